// SPDX-License-Identifier: MIT
// The explicit part of a step: fluxes, body force, and the choice between the two energy equations.
// In cold fast flow the heat is a small difference of two large energies, so beside the total energy E the equation
// de/dt + div(e u) = -p div u is followed through each stage, and its e stands where E - n u^2/2 is below what the
// jumps of velocity around the cell can spoil (Bryan and others 1995, their criterion made Galilean invariant).
#include <cmath>

#include "continuum/boundary/fill_ghosts.hpp"
#include "continuum/evolution.hpp"
#include "continuum/flux/wave_speeds.hpp"

namespace continuum {

namespace {

FaceArrays face_rows(Workspace& work) {
    return {work.row(0), work.row(1), work.row(2), work.row(3), work.row(4), work.row(5), work.row(6), work.row(7)};
}

void close_face(const FaceArrays& faces, std::int64_t f, double stress) {
    faces.mass[f] = faces.tangent_1[f] = faces.tangent_2[f] = faces.energy[f] = faces.internal[f] = faces.velocity[f] =
        0.0;
    faces.normal[f] = stress;
}

}  // namespace

bool Evolution::carry(double t, double dt, SweepKernel sweep) {
    base_ = setup_.flow;
    base_books_ = books_;
    for (const Stage& stage : kernels_.stages) {
        const double gravity = setup_.gravity + setup_.motion.acceleration(t + stage.time * dt);
        bool sound = true;
        for (std::int64_t column = 0; column < grid().columns(); ++column) sweep_along_z(column, sweep, work_[0]);
        for (std::int64_t column = 0; column < grid().columns(); ++column)
            sound = update(column, stage, gravity, dt) && sound;
        if (!sound) return false;
    }
    return true;
}

void Evolution::sweep_along_z(std::int64_t column, SweepKernel sweep, Workspace& work) {
    const std::int64_t nz = grid().nz, first = grid().first(column);
    fill_ghosts(setup_.flow, first, nz, setup_.boundaries, constants_.packing_density);

    Stencil stencil;
    for (std::size_t k = 0; k < 6; ++k) {
        const std::int64_t cell = first - 3 + static_cast<std::int64_t>(k);
        stencil.density[k] = flow().density.data() + cell;
        stencil.normal[k] = flow().velocity_z.data() + cell;
        stencil.tangent_1[k] = flow().velocity_x.data() + cell;
        stencil.tangent_2[k] = flow().velocity_y.data() + cell;
        stencil.temperature[k] = flow().temperature.data() + cell;
    }
    const FaceArrays faces = face_rows(work);
    sweep(stencil, faces, nz + 1, constants_);
    if (setup_.boundaries.lower.end == End::wall) close_face(faces, 0, kernels_.wall(stencil, constants_));
    if (setup_.boundaries.upper.end == End::wall) {
        // The wall kernel wants the gas above the wall: turn the column upside down.
        double upside_down[5][6];
        Stencil turned;
        for (std::size_t k = 0; k < 6; ++k) {
            const std::size_t from = 5 - k;
            upside_down[0][k] = stencil.density[from][nz];
            upside_down[1][k] = -stencil.normal[from][nz];
            upside_down[2][k] = stencil.tangent_1[from][nz];
            upside_down[3][k] = stencil.tangent_2[from][nz];
            upside_down[4][k] = stencil.temperature[from][nz];
            turned.density[k] = &upside_down[0][k];
            turned.normal[k] = &upside_down[1][k];
            turned.tangent_1[k] = &upside_down[2][k];
            turned.tangent_2[k] = &upside_down[3][k];
            turned.temperature[k] = &upside_down[4][k];
        }
        close_face(faces, nz, kernels_.wall(turned, constants_));
    }

    double *pressure = work.row(8), *sound = work.row(9);
    kernels_.pressure(flow().density.data() + first, flow().temperature.data() + first, pressure, sound, nz,
                      constants_);
    const double per_dz = 1.0 / grid().dz;
    double *__restrict mass = rates_.mass.data() + first, *__restrict momentum_x = rates_.momentum_x.data() + first,
                       *__restrict momentum_y = rates_.momentum_y.data() + first,
                       *__restrict momentum_z = rates_.momentum_z.data() + first,
                       *__restrict energy = rates_.energy.data() + first,
                       *__restrict internal = rates_.internal.data() + first, *__restrict jump = rates_.jump.data() + first;
#pragma omp simd
    for (std::int64_t i = 0; i < nz; ++i) {
        mass[i] = per_dz * (faces.mass[i] - faces.mass[i + 1]);
        momentum_x[i] = per_dz * (faces.tangent_1[i] - faces.tangent_1[i + 1]);
        momentum_y[i] = per_dz * (faces.tangent_2[i] - faces.tangent_2[i + 1]);
        momentum_z[i] = per_dz * (faces.normal[i] - faces.normal[i + 1]);
        energy[i] = per_dz * (faces.energy[i] - faces.energy[i + 1]);
        internal[i] = per_dz * ((faces.internal[i] - faces.internal[i + 1]) +
                                pressure[i] * (faces.velocity[i] - faces.velocity[i + 1]));
        jump[i] = larger(faces.jump[i], faces.jump[i + 1]);
    }
    // What passes the ends, for the books: kept in the ghosts of the rates until the update.
    rates_.momentum_z[static_cast<std::size_t>(first - 1)] = faces.normal[0];
    rates_.momentum_z[static_cast<std::size_t>(first + nz)] = faces.normal[nz];
    rates_.energy[static_cast<std::size_t>(first - 1)] = faces.energy[0];
    rates_.energy[static_cast<std::size_t>(first + nz)] = faces.energy[nz];
}

bool Evolution::update(std::int64_t column, const Stage& stage, double gravity, double dt) {
    const std::int64_t nz = grid().nz, first = grid().first(column);
    const double start = stage.start, previous = stage.previous;
    const double packing = constants_.packing_density, floor = constants_.floor_temperature, trust = constants_.trust;
    double *__restrict density = setup_.flow.density.data() + first, *__restrict u_x = setup_.flow.velocity_x.data() + first,
                       *__restrict u_y = setup_.flow.velocity_y.data() + first,
                       *__restrict u_z = setup_.flow.velocity_z.data() + first,
                       *__restrict temperature = setup_.flow.temperature.data() + first;
    const double *base_density = base_.density.data() + first, *base_x = base_.velocity_x.data() + first,
                 *base_y = base_.velocity_y.data() + first, *base_z = base_.velocity_z.data() + first,
                 *base_temperature = base_.temperature.data() + first;
    const double *mass = rates_.mass.data() + first, *momentum_x = rates_.momentum_x.data() + first,
                 *momentum_y = rates_.momentum_y.data() + first, *momentum_z = rates_.momentum_z.data() + first,
                 *energy = rates_.energy.data() + first, *internal = rates_.internal.data() + first,
                 *jump = rates_.jump.data() + first;
    double work = 0.0, corrected = 0.0, floored = 0.0, unsound = 0.0;
#pragma omp simd reduction(+ : work, corrected, floored, unsound)
    for (std::int64_t i = 0; i < nz; ++i) {
        const double n0 = base_density[i], x0 = base_x[i], y0 = base_y[i], z0 = base_z[i];
        const double heat0 = 1.5 * base_temperature[i];
        const double n = density[i], x = u_x[i], y = u_y[i], z = u_z[i], heat = 1.5 * temperature[i];
        const double energy0 = n0 * (heat0 + 0.5 * (z0 * z0 + (x0 * x0 + y0 * y0)));
        const double energy1 = n * (heat + 0.5 * (z * z + (x * x + y * y)));
        const double weight = gravity * (n * z);

        const double new_density = start * n0 + previous * (n + dt * mass[i]);
        const double new_x = start * (n0 * x0) + previous * (n * x + dt * momentum_x[i]);
        const double new_y = start * (n0 * y0) + previous * (n * y + dt * momentum_y[i]);
        const double new_z = start * (n0 * z0) + previous * (n * z + dt * (momentum_z[i] - gravity * n));
        const double new_energy = start * energy0 + previous * (energy1 + dt * (energy[i] - weight));
        const double by_compression = start * (n0 * heat0) + previous * (n * heat + dt * internal[i]);

        const double per_density = 1.0 / new_density;
        const double v_x = new_x * per_density, v_y = new_y * per_density, v_z = new_z * per_density;
        const double left = new_energy - 0.5 * new_density * (v_z * v_z + (v_x * v_x + v_y * v_y));
        const double chosen = left > trust * new_density * jump[i] ? left : by_compression;
        const double least = 1.5 * floor * new_density;
        const double kept = larger(chosen, least);

        const bool admissible =
            (new_density > 0.0) & (new_density < packing) & (std::abs(v_z) < 1e100) & (kept < 1e100);
        work -= weight;
        corrected += chosen - left;
        floored += kept - chosen;
        unsound += admissible ? 0.0 : 1.0;
        density[i] = new_density;
        u_x[i] = v_x;
        u_y[i] = v_y;
        u_z[i] = v_z;
        temperature[i] = (kept * per_density) * (2.0 / 3.0);
    }
    const double dz = grid().dz;
    const auto at = [&](const std::vector<double>& rate, std::int64_t i) {
        return rate[static_cast<std::size_t>(first + i)];
    };
    Ledger& books = books_[static_cast<std::size_t>(column)];
    const Ledger& base = base_books_[static_cast<std::size_t>(column)];
    const auto combine = [&](double Ledger::*entry, double rate) {
        books.*entry = start * (base.*entry) + previous * (books.*entry + dt * rate);
    };
    combine(&Ledger::body_force_work, dz * work);
    combine(&Ledger::boundary_gain, at(rates_.energy, -1) - at(rates_.energy, nz));
    combine(&Ledger::plate_impulse, at(rates_.momentum_z, -1));
    combine(&Ledger::lid_impulse, at(rates_.momentum_z, nz));
    combine(&Ledger::dual_energy_gain, 0.0);
    combine(&Ledger::floor_gain, 0.0);
    combine(&Ledger::collisional_loss, 0.0);
    books.dual_energy_gain += dz * corrected;
    books.floor_gain += dz * floored;
    return unsound == 0.0;
}

}  // namespace continuum
