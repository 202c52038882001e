// SPDX-License-Identifier: MIT
#include "continuum/ftcs/ftcs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <omp.h>

#include <algorithm>
#include <cmath>

#include "continuum/closures/closures.hpp"
#include "continuum/errors.hpp"
#include "continuum/flux/wave_speeds.hpp"
#include "scene/errors.hpp"

namespace shaken::continuum {

namespace {

// Bougie 2004, section 3.2.8, which has 0.16 for the diffusion factor too.
constexpr double courant = 1.5;
constexpr double cooling_share = 0.3;

Grid nodes_of(const Grid& cells) {
    Grid nodes = cells;
    nodes.nz = cells.nz + 1;
    return nodes;
}

/// Nodes from cells such that the trapezoidal rule over the nodes gives the sum over the cells.
void cells_to_nodes(const double* cell, double* node, std::int64_t cells) {
    node[0] = cell[0];
    for (std::int64_t i = 1; i < cells; ++i) node[i] = 0.5 * (cell[i - 1] + cell[i]);
    node[cells] = cell[cells - 1];
}

}  // namespace

void Ftcs::refuse_closure(const scene::Continuum& choices, double restitution) {
    const scene::Choice& closure = choices.closure;
    if (!closure_has_part(choices, restitution) || !traits_of(closure).carries_between_contacts) return;
    std::vector<std::string> can_run = Closures::names();
    std::erase_if(can_run, [](const auto& name) { return traits_of({name, {}}).carries_between_contacts; });
    const bool written = !closure.place.source.empty();
    const bool by_default = !written && closure.name == scene::Continuum{}.closure.name;
    throw scene::SceneError(
        written ? closure.place : choices.scheme.place,
        fmt::format("continuum.scheme = \"ftcs\" cannot run continuum.closure = \"{}\"{}, whose terms in 1/G ask for "
                    "steps of no length where the gas is thin; it can run \"{}\"",
                    closure.name, by_default ? ", the default" : "", fmt::join(can_run, "\", \"")));
}

Ftcs::Ftcs(Setup setup) : setup_(std::move(setup)), dissipation_(setup_.sink) {
    refuse_closure(setup_.choices, setup_.restitution);
    kernels_ = choose_kernels(setup_.choices);
    if (setup_.boundaries.upper.end == End::stress_free)
        throw scene::SceneError(setup_.choices.upper.place,
                                "continuum.upper = \"stress_free\" is for finite volumes: the nodes of "
                                "continuum.scheme = \"ftcs\" that lie in an end bear its whole stress; known with it: "
                                "lid, heated");
    if (setup_.boundaries.lower.end != End::wall || setup_.boundaries.upper.end != End::wall)
        throw scene::SceneError(setup_.choices.scheme.place,
                                "continuum.scheme = \"ftcs\" knows walls only, below and above");
    constants_.restitution = setup_.restitution;
    constants_.virial = 2.0 * (1.0 + setup_.restitution);
    constants_.packing_density = kernels_.packing / sphere_volume;
    strength_ = setup_.choices.artificial_dissipation;
    nodes_ = nodes_of(setup_.grid);
    now_ = Flow(nodes_);
    const auto move = [&](const std::vector<double>& cells, std::vector<double>& nodes) {
        for (std::int64_t c = 0; c < grid().columns(); ++c)
            cells_to_nodes(cells.data() + grid().first(c), nodes.data() + nodes_.first(c), grid().nz);
    };
    for (std::size_t k = 0; k < now_.fields().size(); ++k) move(*setup_.flow.fields()[k], *now_.fields()[k]);
    cells_ = setup_.flow;
    next_ = now_;
    for (auto* array : {&pressure_, &bulk_, &shear_, &conductivity_, &density_conductivity_, &cooling_, &sound_})
        array->assign(nodes_.size(), 0.0);
    smallest_spacing_ = grid().dz;
    if (grid().nx > 1) smallest_spacing_ = std::min(smallest_spacing_, grid().dx);
    if (grid().ny > 1) smallest_spacing_ = std::min(smallest_spacing_, grid().dy);
    floor_density_ = setup_.choices.floor_density * mass() / (grid().dz * static_cast<double>(grid().nz));
    for (std::int64_t c = 0; c < grid().columns(); ++c) enforce_walls(c);
    initial_energy_ = energy();
    initial_potential_energy_ = potential_energy();
    initial_mass_ = mass();
}

// A thread without a column would only wait.
int Ftcs::threads() const { return static_cast<int>(std::min<std::int64_t>(omp_get_max_threads(), grid().columns())); }

void Ftcs::enforce_walls(std::int64_t column) {
    const std::int64_t first = nodes_.first(column), last = first + grid().nz;
    const auto flatten = [&](std::vector<double>& field, std::int64_t wall, std::int64_t inward) {
        double* const at = field.data() + wall;
        at[0] = (4.0 * at[inward] - at[2 * inward]) * (1.0 / 3.0);
    };
    const auto enforce = [&](const Boundary& end, std::int64_t wall, std::int64_t inward) {
        const auto i = static_cast<std::size_t>(wall);
        now_.velocity_z[i] = 0.0;
        flatten(now_.velocity_x, wall, inward);
        flatten(now_.velocity_y, wall, inward);
        flatten(now_.temperature, wall, inward);
        if (end.temperature) now_.temperature[i] = *end.temperature;
        now_.temperature[i] = larger(setup_.floor_temperature, now_.temperature[i]);
    };
    enforce(setup_.boundaries.lower, first, 1);
    enforce(setup_.boundaries.upper, last, -1);
}

void Ftcs::close(std::int64_t column) {
    const std::int64_t first = nodes_.first(column), count = nodes_.nz;
    const double *density = now_.density.data() + first, *temperature = now_.temperature.data() + first;
    kernels_.pressure(density, temperature, pressure_.data() + first, sound_.data() + first, count, constants_);
    const TransportArrays out{bulk_.data() + first, shear_.data() + first, conductivity_.data() + first,
                              density_conductivity_.data() + first, cooling_.data() + first};
    kernels_.transport(density, temperature, out, count, constants_);
    if (kernels_.viscous) return;
    for (double* array : {out.bulk, out.shear, out.conductivity, out.density_conductivity})
        std::fill(array, array + count, 0.0);
}

double Ftcs::longest_step() {
    const double h = smallest_spacing_, h2 = h * h;
    double longest = HUGE_VAL;
#pragma omp parallel for schedule(static) num_threads(threads()) reduction(min : longest)
    for (std::int64_t c = 0; c < grid().columns(); ++c) {
        close(c);
        for (std::int64_t k = 0; k < nodes_.nz; ++k) {
            const auto i = static_cast<std::size_t>(nodes_.first(c) + k);
            const double n = now_.density[i], root = std::sqrt(now_.temperature[i]);
            const double fastest =
                std::max({std::abs(now_.velocity_x[i]), std::abs(now_.velocity_y[i]), std::abs(now_.velocity_z[i])});
            const double stiffest = std::max({shear_[i], bulk_[i], conductivity_[i]});
            // cooling_ is (8/sqrt(pi)) G.
            const double sink = dissipation_(now_.temperature[i]) * cooling_[i] * (1.7724538509055160 / 8.0) * root;
            longest = std::min({longest, courant * h / std::max(fastest, 1e-300),
                                setup_.choices.diffusion_factor * n * h2 / std::max(stiffest, 1e-300),
                                cooling_share / std::max(sink, 1e-300)});
        }
    }
    closed_ = true;
    return longest;
}

void Ftcs::step(double t, double dt) {
    if (!closed_) longest_step();
    const double gravity = setup_.gravity + setup_.motion.acceleration(t);
    const std::int64_t columns = grid().columns();
#pragma omp parallel for schedule(static) num_threads(threads())
    for (std::int64_t c = 0; c < columns; ++c) {
        difference(c, gravity, dt);
        difference_at_wall(c, 0, 1, dt);
        difference_at_wall(c, grid().nz, -1, dt);
    }
    Books books;
    double weight = 0.0;
    bool sound = true;
    for (std::int64_t c = 0; c < columns; ++c) {
        for (std::int64_t k = 1; k < grid().nz; ++k) {
            const auto i = static_cast<std::size_t>(nodes_.first(c) + k);
            weight += now_.density[i] * now_.velocity_z[i];
        }
        const Books of_column = settle(c, dt);
        books.loss += of_column.loss;
        books.heat_of_floor += of_column.heat_of_floor;
        books.mass_of_floor += of_column.mass_of_floor;
        for (std::int64_t k = 0; k < nodes_.nz; ++k) {
            const auto i = static_cast<std::size_t>(nodes_.first(c) + k);
            sound = sound && next_.density[i] < constants_.packing_density && std::abs(next_.velocity_z[i]) < 1e100 &&
                    next_.temperature[i] < 1e100;
        }
    }
    if (!sound) fail(t, dt);
    std::swap(now_, next_);
    for (std::int64_t c = 0; c < columns; ++c) enforce_walls(c);
    const double share = grid().dz / static_cast<double>(columns);
    body_force_work_ -= dt * gravity * weight * share;
    gravity_work_ -= dt * setup_.gravity * weight * share;
    collisional_loss_ += books.loss * share;
    floor_gain_ += books.heat_of_floor * share;
    floor_mass_ += books.mass_of_floor * share;
    ++steps_;
    closed_ = false;
}

Ftcs::Books Ftcs::settle(std::int64_t column, double dt) {
    Books books;
    for (std::int64_t k = 0; k < nodes_.nz; ++k) {
        const auto i = static_cast<std::size_t>(nodes_.first(column) + k);
        const double weight = k == 0 || k == grid().nz ? 0.5 : 1.0;
        const double t = now_.temperature[i];
        books.loss += weight * 1.5 * now_.density[i] * dt * cooling_[i] * dissipation_(t) * t * std::sqrt(t);
        const double n = larger(floor_density_, next_.density[i]);
        const double kept = larger(setup_.floor_temperature, next_.temperature[i]);
        books.mass_of_floor += weight * (n - next_.density[i]);
        books.heat_of_floor += weight * 1.5 * n * (kept - next_.temperature[i]);
        next_.density[i] = n;
        next_.temperature[i] = kept;
    }
    return books;
}

void Ftcs::fail(double t, double dt) const {
    for (std::int64_t c = 0; c < grid().columns(); ++c)
        for (std::int64_t k = 0; k < nodes_.nz; ++k) {
            const auto i = static_cast<std::size_t>(nodes_.first(c) + k);
            if (next_.density[i] < constants_.packing_density && std::abs(next_.velocity_z[i]) < 1e100 &&
                next_.temperature[i] < 1e100)
                continue;
            throw RunFailed(fmt::format("continuum: ftcs left the states there are at time {:.6g} in the cycle (step "
                                        "{:.3g}): column ({}, {}), "
                                        "height {:.4g} above the plate would reach volume fraction {:.6g} (packing "
                                        "{:.4g}), velocity {:.6g}, "
                                        "temperature {:.6g}",
                                        t, dt, c % grid().nx, c / grid().nx, static_cast<double>(k) * grid().dz,
                                        sphere_volume * next_.density[i], kernels_.packing, next_.velocity_z[i],
                                        next_.temperature[i]),
                            t);
        }
    throw RunFailed(fmt::format("continuum: ftcs failed at time {:.6g} in the cycle (step {:.3g})", t, dt), t);
}

const Flow& Ftcs::flow() const {
    const auto average = [&](const std::vector<double>& nodes, std::vector<double>& cells) {
        for (std::int64_t c = 0; c < grid().columns(); ++c) {
            const double* node = nodes.data() + nodes_.first(c);
            double* cell = cells.data() + grid().first(c);
            for (std::int64_t i = 0; i < grid().nz; ++i) cell[i] = 0.5 * (node[i] + node[i + 1]);
        }
    };
    for (std::size_t k = 0; k < now_.fields().size(); ++k) average(*now_.fields()[k], *cells_.fields()[k]);
    return cells_;
}

double Ftcs::mass() const {
    double sum = 0.0;
    for (std::int64_t c = 0; c < grid().columns(); ++c) {
        const double* n = now_.density.data() + nodes_.first(c);
        double column = 0.5 * (n[0] + n[grid().nz]);
        for (std::int64_t k = 1; k < grid().nz; ++k) column += n[k];
        sum += column;
    }
    return sum * grid().dz / static_cast<double>(grid().columns());
}

double Ftcs::mass_share_at_temperature_floor() const {
    double held = 0.0, all = 0.0;
    for (std::int64_t c = 0; c < grid().columns(); ++c)
        for (std::int64_t k = 0; k < nodes_.nz; ++k) {
            const auto i = static_cast<std::size_t>(nodes_.first(c) + k);
            all += now_.density[i];
            if (now_.temperature[i] < 1.01 * setup_.floor_temperature) held += now_.density[i];
        }
    return held / all;
}

double Ftcs::energy() const {
    double sum = 0.0;
    for (std::int64_t c = 0; c < grid().columns(); ++c)
        for (std::int64_t k = 0; k < nodes_.nz; ++k) {
            const auto i = static_cast<std::size_t>(nodes_.first(c) + k);
            const double u2 = now_.velocity_x[i] * now_.velocity_x[i] + now_.velocity_y[i] * now_.velocity_y[i] +
                              now_.velocity_z[i] * now_.velocity_z[i];
            const double weight = k == 0 || k == grid().nz ? 0.5 : 1.0;
            sum += weight * now_.density[i] * (1.5 * now_.temperature[i] + 0.5 * u2);
        }
    return sum * grid().dz / static_cast<double>(grid().columns());
}

double Ftcs::potential_energy() const {
    double moment = 0.0;  // the lowest node lies at height 0
    for (std::int64_t c = 0; c < grid().columns(); ++c) {
        const double* n = now_.density.data() + nodes_.first(c);
        for (std::int64_t k = 1; k < grid().nz; ++k) moment += n[k] * static_cast<double>(k);
        moment += 0.5 * n[grid().nz] * static_cast<double>(grid().nz);
    }
    return setup_.gravity * moment * grid().dz * grid().dz / static_cast<double>(grid().columns());
}

Ledger Ftcs::ledger() const {
    Ledger l;
    l.energy = energy();
    l.initial_energy = initial_energy_;
    l.body_force_work = body_force_work_;
    l.gravity_work = gravity_work_;
    l.potential_gain = potential_energy() - initial_potential_energy_;
    l.collisional_loss = collisional_loss_;
    l.floor_gain = floor_gain_;
    l.dual_energy_gain = l.energy - (initial_energy_ + body_force_work_ - collisional_loss_ + floor_gain_);
    return l;
}

Drift Ftcs::drift() const {
    const Ledger l = ledger();
    return {mass() / initial_mass_ - 1.0, l.dual_energy_gain / (l.initial_energy + l.collisional_loss)};
}

// Forward Euler multiplies a wave with dx/dt = M x by 1 + dt M. With K the second difference, h^2 K at most 4 a
// direction,
//     diffusion  dt D K <= 2          for D the viscosity of sound, (lambda + 4 mu/3)/n, and for 2 kappa/(3n)
//     sound      dt c^2 <= 2 Gamma    c and Gamma speed and attenuation of long waves
//                dt c_T^2 <= D        short ones, which conduct so fast that they are isothermal
// D and 2 kappa/(3n) with the artificial C_AD h^2 exp(-200 nu)/dt.
double Ftcs::unstable_share(double dt) const {
    const auto squared = [](double spacing) { return 4.0 / (spacing * spacing); };
    const double curvature =
        squared(grid().dz) + (grid().nx > 1 ? squared(grid().dx) : 0.0) + (grid().ny > 1 ? squared(grid().dy) : 0.0);
    const double artificial = strength_ * smallest_spacing_ * smallest_spacing_ / dt;
    double unstable = 0.0, all = 0.0;
    for (std::int64_t c = 0; c < grid().columns(); ++c)
        for (std::int64_t k = 0; k < nodes_.nz; ++k) {
            const auto i = static_cast<std::size_t>(nodes_.first(c) + k);
            const double n = now_.density[i], temperature = now_.temperature[i];
            const double fade = artificial * scene::exponential(-200.0 * sphere_volume * n);
            const double viscous = (bulk_[i] + (4.0 / 3.0) * shear_[i]) / n + fade;
            const double thermal = (2.0 / 3.0) * conductivity_[i] / n + fade;
            const double adiabatic = sound_[i] * sound_[i], chi = pressure_[i] / (n * temperature);
            const double isothermal = adiabatic - (2.0 / 3.0) * chi * chi * temperature;
            const double attenuation = 0.5 * (viscous + thermal * (1.0 - isothermal / adiabatic));
            const bool stable = dt * curvature * larger(viscous, thermal) <= 2.0 &&
                                dt * adiabatic <= 2.0 * attenuation && dt * isothermal <= viscous;
            all += n;
            if (!stable) unstable += n;
        }
    return unstable / all;
}

void Ftcs::save(files::CheckpointWriter& out) const {
    out.put("continuum/cells", std::vector<std::int64_t>{grid().nx, grid().ny, grid().nz});
    save_flow(now_, out);
    out.put("continuum/ftcs",
            std::vector<double>{body_force_work_, collisional_loss_, floor_gain_, floor_mass_, initial_energy_,
                                floor_density_, initial_mass_, gravity_work_, initial_potential_energy_});
    out.put("continuum/steps", steps_);
}

void Ftcs::restore(const files::CheckpointReader& in) {
    restore_flow(now_, in);
    std::vector<double> books(9);
    in.take_into("continuum/ftcs", std::span(books));
    body_force_work_ = books[0];
    collisional_loss_ = books[1];
    floor_gain_ = books[2];
    floor_mass_ = books[3];
    initial_energy_ = books[4];
    floor_density_ = books[5];
    initial_mass_ = books[6];
    gravity_work_ = books[7];
    initial_potential_energy_ = books[8];
    steps_ = in.take_one<std::int64_t>("continuum/steps");
    closed_ = false;
}

}  // namespace shaken::continuum
