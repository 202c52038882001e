// SPDX-License-Identifier: MIT
#include "continuum/evolution.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "continuum/boundary/fill_ghosts.hpp"
#include "continuum/closures/pressure.hpp"
#include "continuum/errors.hpp"
#include "continuum/flux/wave_speeds.hpp"

namespace shaken::continuum {

namespace {

constexpr std::size_t rows_of_work = 24;
// A step is halved at most this often before the run is given up: by then it is 1/1024 of what the waves allow.
constexpr int most_halvings = 10;
constexpr int halvings_at_full_order = 3;
// Where the total energy leaves less heat than this share of n (jump of u)^2 its truncation error may exceed it.
constexpr double trust_total_energy = 1e-3;

}  // namespace

Workspace::Workspace(std::int64_t cells)
    : length_((cells + 2 * Grid::ghosts + 8) / 8 * 8), rows_(rows_of_work * static_cast<std::size_t>(length_), 0.0) {}

Evolution::Evolution(Setup setup)
    : setup_(std::move(setup)),
      kernels_(choose_kernels(setup_.choices)),
      dissipation_(setup_.sink),
      base_(setup_.flow),
      start_(setup_.flow) {
    constants_.restitution = setup_.restitution;
    constants_.virial = 2.0 * (1.0 + setup_.restitution);
    constants_.packing_density = kernels_.packing / sphere_volume;
    constants_.floor_temperature = setup_.floor_temperature;
    constants_.trust = trust_total_energy;
    const std::vector<double> zero(grid().size(), 0.0);
    rates_ = {zero, zero, zero, zero, zero, zero, zero, zero};
    coefficients_ = {zero, zero, zero, zero, zero};
    if (grid().columns() > 1) thermal_speed_ = zero;
    work_.assign(static_cast<std::size_t>(threads()), Workspace(grid().nz));
    books_.resize(static_cast<std::size_t>(grid().columns()));
    base_books_ = start_books_ = books_;
    const auto moves = [](const std::vector<double>& u) {
        for (double v : u)
            if (v != 0.0) return true;
        return false;
    };
    moves_along_x_ = grid().nx > 1 || moves(setup_.flow.velocity_x);
    moves_along_y_ = grid().ny > 1 || moves(setup_.flow.velocity_y);
    initial_energy_ = total_energy();
    initial_potential_energy_ = potential_energy();
}

int Evolution::threads() const {
    return static_cast<int>(std::min<std::int64_t>(omp_get_max_threads(), grid().columns()));
}

std::size_t Evolution::thread() { return static_cast<std::size_t>(omp_get_thread_num()); }

void Evolution::copy_column(const Flow& from, Flow& to, std::int64_t column) const {
    const std::int64_t begin = grid().first(column), end = begin + grid().nz;
    const auto copy = [&](const std::vector<double>& source, std::vector<double>& target) {
        std::copy(source.begin() + begin, source.begin() + end, target.begin() + begin);
    };
    copy(from.density, to.density);
    copy(from.velocity_x, to.velocity_x);
    copy(from.velocity_y, to.velocity_y);
    copy(from.velocity_z, to.velocity_z);
    copy(from.temperature, to.temperature);
}

// Each carry is cfl of what the fastest direction allows, and no more than what all directions together do: an unsplit
// scheme is stable while the Courant numbers add up to less than one. Cells ten times wider than high leave the first
// condition the stricter one, so that a flow uniform in x and y takes the steps of one column.
double Evolution::longest_step() {
    const std::int64_t nz = grid().nz, columns = grid().columns();
    const double per_dx = grid().nx > 1 ? 1.0 / grid().dx : 0.0, per_dy = grid().ny > 1 ? 1.0 / grid().dy : 0.0;
    const double per_dz = 1.0 / grid().dz, packing = constants_.packing_density;
    double fastest = 0.0, together = 0.0;
#pragma omp parallel for schedule(static) num_threads(threads()) reduction(max : fastest, together)
    for (std::int64_t column = 0; column < columns; ++column) {
        Workspace& work = work_[thread()];
        const std::int64_t first = grid().first(column);
        fill_ghosts(setup_.flow, first, nz, setup_.boundaries, packing);
        // Rows start one ghost below the column.
        double *pressure = work.row(0), *sound = work.row(1), *vertical = work.row(2);
        const double* density = flow().density.data() + first - 1;
        const double* velocity = flow().velocity_z.data() + first - 1;
        kernels_.pressure(density, flow().temperature.data() + first - 1, pressure, sound, nz + 2, constants_);
        double rate = 0.0;
#pragma omp simd reduction(max : rate)
        for (std::int64_t f = 0; f <= nz; ++f) {
            const double closing = kinematic_speed(density[f], density[f + 1], velocity[f] - velocity[f + 1], packing);
            const double speed = larger(std::abs(velocity[f]), std::abs(velocity[f + 1])) +
                                 larger(larger(sound[f], sound[f + 1]), closing);
            vertical[f] = per_dz * speed;
            rate = larger(rate, vertical[f]);
        }
        double all = rate;
        if (columns > 1) {
            const double *u_x = flow().velocity_x.data() + first, *u_y = flow().velocity_y.data() + first;
#pragma omp simd reduction(max : rate, all)
            for (std::int64_t i = 0; i < nz; ++i) {
                const double along_x = per_dx * (std::abs(u_x[i]) + sound[i + 1]);
                const double along_y = per_dy * (std::abs(u_y[i]) + sound[i + 1]);
                rate = larger(rate, larger(along_x, along_y));
                all = larger(all, larger(vertical[i], vertical[i + 1]) + (along_x + along_y));
            }
        }
        fastest = larger(fastest, rate);
        together = larger(together, all);
    }
    return static_cast<double>(carries_a_step) * smaller(setup_.choices.cfl / fastest, 1.0 / together);
}

void Evolution::step(double t, double dt) {
    struct Piece {
        double t, dt;
        int halvings;
    };
    const Sweeps usual{kernels_.sweep, kernels_.sweep_horizontal, kernels_.sweep_thin};
    const Sweeps careful{kernels_.sweep_first_order, kernels_.sweep_first_order, kernels_.sweep_first_order};
    // Pieces still to do, the next one last.
    std::vector<Piece> pieces{{t, dt, 0}};
    while (!pieces.empty()) {
        const Piece piece = pieces.back();
        pieces.pop_back();
#pragma omp parallel for schedule(static) num_threads(threads())
        for (std::int64_t column = 0; column < grid().columns(); ++column) copy_column(flow(), start_, column);
        start_books_ = books_;
        const bool first_order = piece.halvings > halvings_at_full_order;
        if (try_step(piece.t, piece.dt, first_order ? careful : usual)) {
            ++steps_;
            continue;
        }
        ++repeated_;
        if (piece.halvings == most_halvings) {
            std::swap(setup_.flow, start_);
            std::swap(books_, start_books_);
            fail(piece.t, piece.dt);  // what start_ now holds is the state that was refused
        }
        setup_.flow = start_;
        books_ = start_books_;
        const double half = 0.5 * piece.dt;
        pieces.push_back({piece.t + half, half, piece.halvings + 1});
        pieces.push_back({piece.t, half, piece.halvings + 1});
    }
}

bool Evolution::try_step(double t, double dt, const Sweeps& sweeps) {
    const double half = 0.5 * dt;
    if (!carry(t, half, sweeps)) return false;
    relax(dt);
    return carry(t + half, half, sweeps);
}

void Evolution::fail(double t, double dt) const {
    for (std::int64_t column = 0; column < grid().columns(); ++column)
        for (std::int64_t iz = 0; iz < grid().nz; ++iz) {
            const auto i = static_cast<std::size_t>(grid().first(column) + iz);
            const double n = start_.density[i], temperature = start_.temperature[i];
            if (n > 0.0 && n < constants_.packing_density && temperature > 0.0 && std::isfinite(start_.velocity_z[i]) &&
                std::isfinite(temperature))
                continue;
            throw RunFailed(fmt::format("continuum: no step can be made at time {:.6g} in the cycle (the last one "
                                        "tried was {:.3g}): column "
                                        "({}, {}), height {:.4g} above the plate would reach volume fraction {:.6g} "
                                        "(packing {:.4g}), velocity "
                                        "{:.6g}, temperature {:.6g}",
                                        t, dt, column % grid().nx, column / grid().nx, grid().centre(iz),
                                        sphere_volume * n, kernels_.packing, start_.velocity_z[i], temperature),
                            t);
        }
    throw RunFailed(
        fmt::format("continuum: no step can be made at time {:.6g} in the cycle (the last one tried was {:.3g})", t,
                    dt),
        t);
}

double Evolution::bytes_per_cell() const {
    std::size_t doubles = 0;
    for (const Flow* flow : {&setup_.flow, &base_, &start_})
        doubles += flow->density.size() + flow->velocity_x.size() + flow->velocity_y.size() + flow->velocity_z.size() +
                   flow->temperature.size();
    doubles += 8 * rates_.mass.size() + 5 * coefficients_.bulk.size() + thermal_speed_.size();
    return 8.0 * static_cast<double>(doubles) / static_cast<double>(grid().cells());
}

double Evolution::mass() const {
    double all = 0.0;
    for (std::int64_t column = 0; column < grid().columns(); ++column) {
        double sum = 0.0;
        const double* n = flow().density.data() + grid().first(column);
        for (std::int64_t i = 0; i < grid().nz; ++i) sum += n[i];
        all += sum;
    }
    return all * grid().dz / static_cast<double>(grid().columns());
}

double Evolution::mass_share_at_temperature_floor() const {
    double held = 0.0;
    for (std::int64_t column = 0; column < grid().columns(); ++column)
        for (std::int64_t iz = 0; iz < grid().nz; ++iz) {
            const auto i = static_cast<std::size_t>(grid().first(column) + iz);
            // A step of diffusion may leave a cell a little above the floor it was put on.
            if (flow().temperature[i] < 1.01 * constants_.floor_temperature) held += flow().density[i];
        }
    return held * grid().dz / (static_cast<double>(grid().columns()) * mass());
}

double Evolution::total_energy() const {
    double all = 0.0;
    for (std::int64_t column = 0; column < grid().columns(); ++column) {
        double sum = 0.0;
        for (std::int64_t iz = 0; iz < grid().nz; ++iz) {
            const auto i = static_cast<std::size_t>(grid().first(column) + iz);
            const double ux = flow().velocity_x[i], uy = flow().velocity_y[i], uz = flow().velocity_z[i];
            sum += flow().density[i] * (1.5 * flow().temperature[i] + 0.5 * (ux * ux + uy * uy + uz * uz));
        }
        all += sum;
    }
    return all * grid().dz / static_cast<double>(grid().columns());
}

double Evolution::potential_energy() const {
    double all = 0.0;
    for (std::int64_t column = 0; column < grid().columns(); ++column) {
        double moment = 0.0;
        const double* n = flow().density.data() + grid().first(column);
        for (std::int64_t i = 0; i < grid().nz; ++i) moment += n[i] * grid().centre(i);
        all += moment;
    }
    return setup_.gravity * all * grid().dz / static_cast<double>(grid().columns());
}

Ledger Evolution::ledger() const {
    Ledger sum;
    for (const Ledger& column : books_) {
        sum.body_force_work += column.body_force_work;
        sum.gravity_work += column.gravity_work;
        sum.collisional_loss += column.collisional_loss;
        sum.floor_gain += column.floor_gain;
        sum.dual_energy_gain += column.dual_energy_gain;
        sum.boundary_gain += column.boundary_gain;
        sum.plate_impulse += column.plate_impulse;
        sum.lid_impulse += column.lid_impulse;
    }
    const double share = 1.0 / static_cast<double>(books_.size());
    for (double* entry : {&sum.body_force_work, &sum.gravity_work, &sum.collisional_loss, &sum.floor_gain,
                          &sum.dual_energy_gain, &sum.boundary_gain, &sum.plate_impulse, &sum.lid_impulse})
        *entry *= share;
    sum.energy = total_energy();
    sum.initial_energy = initial_energy_;
    sum.potential_gain = potential_energy() - initial_potential_energy_;
    return sum;
}

Drift Evolution::drift() const {
    const Ledger books = ledger();
    return {0.0, books.dual_energy_gain / (books.initial_energy + books.collisional_loss)};
}

void Evolution::save(files::CheckpointWriter& out) const {
    out.put("continuum/cells", std::vector<std::int64_t>{grid().nx, grid().ny, grid().nz});
    out.put("continuum/density", flow().density);
    out.put("continuum/velocity_x", flow().velocity_x);
    out.put("continuum/velocity_y", flow().velocity_y);
    out.put("continuum/velocity_z", flow().velocity_z);
    out.put("continuum/temperature", flow().temperature);
    out.put("continuum/books", books_);
    out.put("continuum/initial_energy", initial_energy_);
    out.put("continuum/initial_potential_energy", initial_potential_energy_);
    out.put("continuum/steps", steps_);
    out.put("continuum/repeated_steps", repeated_);
}

void Evolution::restore(const files::CheckpointReader& in) {
    const auto span = [](auto& values) { return std::span(values.data(), values.size()); };
    in.take_into("continuum/density", span(setup_.flow.density));
    in.take_into("continuum/velocity_x", span(setup_.flow.velocity_x));
    in.take_into("continuum/velocity_y", span(setup_.flow.velocity_y));
    in.take_into("continuum/velocity_z", span(setup_.flow.velocity_z));
    in.take_into("continuum/temperature", span(setup_.flow.temperature));
    in.take_into("continuum/books", span(books_));
    initial_energy_ = in.take_one<double>("continuum/initial_energy");
    initial_potential_energy_ = in.take_one<double>("continuum/initial_potential_energy");
    steps_ = in.take_one<std::int64_t>("continuum/steps");
    repeated_ = in.take_one<std::int64_t>("continuum/repeated_steps");
}

}  // namespace shaken::continuum
