// SPDX-License-Identifier: MIT
#include "continuum/evolution.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "continuum/boundary/fill_ghosts.hpp"
#include "continuum/closures/pressure.hpp"
#include "continuum/errors.hpp"
#include "continuum/flux/wave_speeds.hpp"

namespace continuum {

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
    rates_ = {zero, zero, zero, zero, zero, zero, zero};
    work_.emplace_back(grid().nz);
    books_.resize(static_cast<std::size_t>(grid().columns()));
    base_books_ = start_books_ = books_;
    const auto moves = [](const std::vector<double>& u) {
        for (double v : u)
            if (v != 0.0) return true;
        return false;
    };
    transverse_ = grid().columns() > 1 || moves(setup_.flow.velocity_x) || moves(setup_.flow.velocity_y);
    initial_energy_ = total_energy();
}

double Evolution::longest_step() {
    Workspace& work = work_[0];
    const std::int64_t nz = grid().nz;
    double fastest = 0.0;
    for (std::int64_t column = 0; column < grid().columns(); ++column) {
        const std::int64_t first = grid().first(column);
        fill_ghosts(setup_.flow, first, nz, setup_.boundaries, constants_.packing_density);
        // Rows start one ghost below the column.
        double *pressure = work.row(0), *sound = work.row(1);
        const double* density = flow().density.data() + first - 1;
        const double* velocity = flow().velocity_z.data() + first - 1;
        kernels_.pressure(density, flow().temperature.data() + first - 1, pressure, sound, nz + 2, constants_);
        const double packing = constants_.packing_density;
#pragma omp simd reduction(max : fastest)
        for (std::int64_t f = 0; f <= nz; ++f) {
            const double closing = kinematic_speed(density[f], density[f + 1], velocity[f] - velocity[f + 1], packing);
            const double speed = larger(std::abs(velocity[f]), std::abs(velocity[f + 1])) +
                                 larger(larger(sound[f], sound[f + 1]), closing);
            fastest = larger(fastest, speed);
        }
    }
    return setup_.choices.cfl * grid().dz / fastest;
}

void Evolution::step(double t, double dt) {
    struct Piece {
        double t, dt;
        int halvings;
    };
    // Pieces still to do, the next one last.
    std::vector<Piece> pieces{{t, dt, 0}};
    while (!pieces.empty()) {
        const Piece piece = pieces.back();
        pieces.pop_back();
        start_ = setup_.flow;
        start_books_ = books_;
        const bool first_order = piece.halvings > halvings_at_full_order;
        if (try_step(piece.t, piece.dt, first_order ? kernels_.sweep_first_order : kernels_.sweep)) {
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

bool Evolution::try_step(double t, double dt, SweepKernel sweep) {
    const bool forward = steps_ % 2 == 0;
    if (forward) {
        relax(dt, true);
        return carry(t, dt, sweep);
    }
    if (!carry(t, dt, sweep)) return false;
    relax(dt, false);
    return true;
}

void Evolution::fail(double t, double dt) const {
    for (std::int64_t column = 0; column < grid().columns(); ++column)
        for (std::int64_t iz = 0; iz < grid().nz; ++iz) {
            const auto i = static_cast<std::size_t>(grid().first(column) + iz);
            const double n = start_.density[i], temperature = start_.temperature[i];
            if (n > 0.0 && n < constants_.packing_density && temperature > 0.0 && std::isfinite(start_.velocity_z[i]) &&
                std::isfinite(temperature))
                continue;
            throw RunFailed(fmt::format(
                "continuum: no step can be made at time {:.6g} in the cycle (the last one tried was {:.3g}): column "
                "({}, {}), height {:.4g} above the plate would reach volume fraction {:.6g} (packing {:.4g}), velocity "
                "{:.6g}, temperature {:.6g}",
                t, dt, column % grid().nx, column / grid().nx, grid().centre(iz), sphere_volume * n, kernels_.packing,
                start_.velocity_z[i], temperature));
        }
    throw RunFailed(fmt::format(
        "continuum: no step can be made at time {:.6g} in the cycle (the last one tried was {:.3g})", t, dt));
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

Ledger Evolution::ledger() const {
    Ledger sum;
    for (const Ledger& column : books_) {
        sum.body_force_work += column.body_force_work;
        sum.collisional_loss += column.collisional_loss;
        sum.floor_gain += column.floor_gain;
        sum.dual_energy_gain += column.dual_energy_gain;
        sum.boundary_gain += column.boundary_gain;
        sum.plate_impulse += column.plate_impulse;
        sum.lid_impulse += column.lid_impulse;
    }
    const double share = 1.0 / static_cast<double>(books_.size());
    for (double* entry : {&sum.body_force_work, &sum.collisional_loss, &sum.floor_gain, &sum.dual_energy_gain,
                          &sum.boundary_gain, &sum.plate_impulse, &sum.lid_impulse})
        *entry *= share;
    sum.energy = total_energy();
    sum.initial_energy = initial_energy_;
    return sum;
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
    steps_ = in.take_one<std::int64_t>("continuum/steps");
    repeated_ = in.take_one<std::int64_t>("continuum/repeated_steps");
}

}  // namespace continuum
