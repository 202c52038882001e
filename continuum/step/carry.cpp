// SPDX-License-Identifier: MIT
// The explicit part of a step: fluxes, body force, and the choice between the two energy equations.
// In cold fast flow the heat is a small difference of two large energies, so beside the total energy E the equation
// de/dt + div(e u) = -p div u is followed through each stage, and its e stands where E - n u^2/2 is below what the
// jumps of velocity around the cell can spoil (Bryan and others 1995, their criterion made Galilean invariant).
// Gravity works on the mass that passes the faces, g F dz at each, half of it in either cell: what it gives is what the
// column's potential energy loses, to round-off, and a column at rest, through whose faces nothing passes, gets none.
#include "continuum/step/carry.hpp"

#include <cmath>

#include "continuum/boundary/fill_ghosts.hpp"
#include "continuum/flux/wave_speeds.hpp"
#include "continuum/step/sum_in_lanes.hpp"

namespace shaken::continuum {

namespace {

void close_face(const FaceArrays& faces, std::int64_t f, double stress) {
    faces.mass[f] = faces.tangent_1[f] = faces.tangent_2[f] = faces.energy[f] = faces.internal[f] = faces.velocity[f] =
        0.0;
    faces.normal[f] = stress;
}

}  // namespace

Carry::Carry(Fluid& fluid)
    : fluid_(fluid), base_(fluid.flow()), base_books_(fluid.books), scratch_(rows_of_threads<Scratch>(fluid)) {}

std::size_t Carry::doubles() const { return base_.fields().size() * base_.density.size(); }

bool Carry::operator()(double t, double dt, const Sweeps& sweeps) {
    const Grid& grid = fluid_.grid();
    const Setup& setup = fluid_.setup;
    const std::int64_t columns = grid.columns();
    const bool along_x = grid.nx > 1, along_y = grid.ny > 1;
    for (std::size_t k = 0; k < fluid_.kernels.stages.size(); ++k) {
        const Stage& stage = fluid_.kernels.stages[k];
        const double gravity = setup.gravity + setup.motion.acceleration(t + stage.time * dt);
        const std::int64_t rows = along_x || along_y ? rows_with_gas() : grid.nz;
        double unsound = 0.0;
#pragma omp parallel num_threads(fluid_.threads()) reduction(+ : unsound)
        {
#pragma omp for schedule(static)
            for (std::int64_t column = 0; column < columns; ++column) {
                const std::int64_t first = grid.first(column);
                fill_ghosts(fluid_.flow(), first, grid.nz, setup.boundaries, fluid_.constants.packing_density);
                fluid_.kernels.pressure(setup.flow.density.data() + first, setup.flow.temperature.data() + first,
                                        fluid_.rates.pressure.data() + first, scratch_[thread()].sound_speed, grid.nz,
                                        fluid_.constants);
            }
            // z + (x + y), in this order, so that a flow turned by a right angle about z keeps its bits.
            if (along_x) sweep_along_x(sweeps, rows);
            if (along_y) sweep_along_y(sweeps, rows, !along_x);
#pragma omp for schedule(static)
            for (std::int64_t column = 0; column < columns; ++column)
                sweep_along_z(column, sweeps.vertical, !along_x && !along_y, gravity);
#pragma omp for schedule(static)
            for (std::int64_t column = 0; column < columns; ++column)
                unsound += update(column, stage, k == 0, gravity, dt) ? 0.0 : 1.0;
        }
        if (unsound > 0.0) return false;
    }
    return true;
}

void Carry::add_rates(std::int64_t column, const FaceArrays& lower, const FaceArrays& upper, Direction direction,
                      double spacing, bool first_sweep) {
    const std::int64_t nz = fluid_.grid().nz, first = fluid_.grid().first(column);
    const double per_width = 1.0 / spacing;
    Fluid::Rates& rates = fluid_.rates;
    std::vector<double>* const momenta[3] = {&rates.momentum_x, &rates.momentum_y, &rates.momentum_z};
    const int normal = static_cast<int>(direction);
    const int one = direction == Direction::x ? 1 : 0, two = direction == Direction::z ? 1 : 2;
    const double* pressure = rates.pressure.data() + first;
    double *__restrict mass = rates.mass.data() + first, *__restrict momentum = momenta[normal]->data() + first,
                       *__restrict momentum_1 = momenta[one]->data() + first,
                       *__restrict momentum_2 = momenta[two]->data() + first, *__restrict energy = rates.energy.data() + first,
                       *__restrict internal = rates.internal.data() + first, *__restrict jump = rates.jump.data() + first;
    const double keep = first_sweep ? 0.0 : 1.0;
#pragma omp simd
    for (std::int64_t i = 0; i < nz; ++i) {
        mass[i] = keep * mass[i] + per_width * (lower.mass[i] - upper.mass[i]);
        momentum[i] = keep * momentum[i] + per_width * (lower.normal[i] - upper.normal[i]);
        momentum_1[i] = keep * momentum_1[i] + per_width * (lower.tangent_1[i] - upper.tangent_1[i]);
        momentum_2[i] = keep * momentum_2[i] + per_width * (lower.tangent_2[i] - upper.tangent_2[i]);
        energy[i] = keep * energy[i] + per_width * (lower.energy[i] - upper.energy[i]);
        internal[i] = keep * internal[i] + per_width * ((lower.internal[i] - upper.internal[i]) +
                                                        pressure[i] * (lower.velocity[i] - upper.velocity[i]));
        jump[i] = larger(keep * jump[i], larger(lower.jump[i], upper.jump[i]));
    }
}

void Carry::sweep_along_z(std::int64_t column, SweepKernel sweep, bool first_sweep, double gravity) {
    const std::int64_t nz = fluid_.grid().nz, first = fluid_.grid().first(column);
    const Flow& flow = fluid_.flow();
    const Boundaries& ends = fluid_.setup.boundaries;
    Fluid::Rates& rates = fluid_.rates;
    Scratch& scratch = scratch_[thread()];
    Stencil stencil;
    for (std::size_t k = 0; k < 6; ++k) {
        const std::int64_t cell = first - 3 + static_cast<std::int64_t>(k);
        stencil.density[k] = flow.density.data() + cell;
        stencil.normal[k] = flow.velocity_z.data() + cell;
        stencil.tangent_1[k] = flow.velocity_x.data() + cell;
        stencil.tangent_2[k] = flow.velocity_y.data() + cell;
        stencil.temperature[k] = flow.temperature.data() + cell;
    }
    const FaceArrays faces = scratch.faces.arrays();
    sweep(stencil, faces, nz + 1, fluid_.constants);
    if (reflects(ends.lower.end)) close_face(faces, 0, fluid_.kernels.wall(stencil, fluid_.constants));
    if (reflects(ends.upper.end)) close_face(faces, nz, stress_below_wall(stencil, nz));
    add_rates(column, faces, faces.shifted(1), Direction::z, fluid_.grid().dz, first_sweep);
    double* __restrict energy = rates.energy.data() + first;
    const double* mass = faces.mass;
    double* __restrict passing = scratch.passing;
#pragma omp simd
    for (std::int64_t i = 0; i < nz; ++i) {
        passing[i] = 0.5 * (mass[i] + mass[i + 1]);
        energy[i] -= gravity * passing[i];
    }
    // What gravity lifts and what passes the ends, for the books: kept in the ghosts of the rates until the update.
    rates.mass[static_cast<std::size_t>(first - 1)] = sum_in_lanes(passing, nz);
    rates.momentum_z[static_cast<std::size_t>(first - 1)] = faces.normal[0];
    rates.momentum_z[static_cast<std::size_t>(first + nz)] = faces.normal[nz];
    rates.energy[static_cast<std::size_t>(first - 1)] = faces.energy[0];
    rates.energy[static_cast<std::size_t>(first + nz)] = faces.energy[nz];
}

double Carry::stress_below_wall(const Stencil& stencil, std::int64_t face) const {
    // The wall kernel wants the gas above the wall: turn the column upside down.
    double upside_down[5][6];
    Stencil turned;
    for (std::size_t k = 0; k < 6; ++k) {
        const std::size_t from = 5 - k;
        upside_down[0][k] = stencil.density[from][face];
        upside_down[1][k] = -stencil.normal[from][face];
        upside_down[2][k] = stencil.tangent_1[from][face];
        upside_down[3][k] = stencil.tangent_2[from][face];
        upside_down[4][k] = stencil.temperature[from][face];
        turned.density[k] = &upside_down[0][k];
        turned.normal[k] = &upside_down[1][k];
        turned.tangent_1[k] = &upside_down[2][k];
        turned.tangent_2[k] = &upside_down[3][k];
        turned.temperature[k] = &upside_down[4][k];
    }
    return fluid_.kernels.wall(turned, fluid_.constants);
}

bool Carry::update(std::int64_t column, const Stage& stage, bool first_stage, double gravity, double dt) {
    const std::int64_t nz = fluid_.grid().nz, first = fluid_.grid().first(column);
    Flow& flow = fluid_.flow();
    const Fluid::Rates& rates = fluid_.rates;
    if (first_stage) {
        copy_column(fluid_.grid(), flow, base_, column);
        base_books_[static_cast<std::size_t>(column)] = fluid_.books_of(column);
    }
    const double start = stage.start, previous = stage.previous, packing = fluid_.constants.packing_density;
    const double floor = fluid_.constants.floor_temperature, trust = fluid_.constants.trust;
    double *__restrict density = flow.density.data() + first, *__restrict u_x = flow.velocity_x.data() + first,
                       *__restrict u_y = flow.velocity_y.data() + first,
                       *__restrict u_z = flow.velocity_z.data() + first,
                       *__restrict temperature = flow.temperature.data() + first;
    const double *base_density = base_.density.data() + first, *base_x = base_.velocity_x.data() + first,
                 *base_y = base_.velocity_y.data() + first, *base_z = base_.velocity_z.data() + first,
                 *base_temperature = base_.temperature.data() + first;
    const double *mass = rates.mass.data() + first, *momentum_x = rates.momentum_x.data() + first,
                 *momentum_y = rates.momentum_y.data() + first, *momentum_z = rates.momentum_z.data() + first,
                 *energy = rates.energy.data() + first, *internal = rates.internal.data() + first,
                 *jump = rates.jump.data() + first;
    double* __restrict corrected = scratch_[thread()].corrected;
    double* __restrict floored = scratch_[thread()].floored;
    double unsound = 0.0;  // whole numbers: any order gives the same sum
#pragma omp simd reduction(+ : unsound)
    for (std::int64_t i = 0; i < nz; ++i) {
        const double n0 = base_density[i], x0 = base_x[i], y0 = base_y[i], z0 = base_z[i];
        const double heat0 = 1.5 * base_temperature[i];
        const double n = density[i], x = u_x[i], y = u_y[i], z = u_z[i], heat = 1.5 * temperature[i];
        const double energy0 = n0 * (heat0 + 0.5 * (z0 * z0 + (x0 * x0 + y0 * y0)));
        const double energy1 = n * (heat + 0.5 * (z * z + (x * x + y * y)));

        const double new_density = start * n0 + previous * (n + dt * mass[i]);
        const double new_x = start * (n0 * x0) + previous * (n * x + dt * momentum_x[i]);
        const double new_y = start * (n0 * y0) + previous * (n * y + dt * momentum_y[i]);
        const double new_z = start * (n0 * z0) + previous * (n * z + dt * (momentum_z[i] - gravity * n));
        const double new_energy = start * energy0 + previous * (energy1 + dt * energy[i]);
        const double by_compression = start * (n0 * heat0) + previous * (n * heat + dt * internal[i]);

        const double per_density = 1.0 / new_density;
        const double v_x = new_x * per_density, v_y = new_y * per_density, v_z = new_z * per_density;
        const double left = new_energy - 0.5 * new_density * (v_z * v_z + (v_x * v_x + v_y * v_y));
        const double chosen = left > trust * new_density * jump[i] ? left : by_compression;
        const double least = 1.5 * floor * new_density;
        const double kept = larger(least, chosen);

        const bool admissible = (new_density > 0.0) & (new_density < packing) & (std::abs(v_x) < 1e100) &
                                (std::abs(v_y) < 1e100) & (std::abs(v_z) < 1e100) & (kept < 1e100);
        corrected[i] = chosen - left;
        floored[i] = kept - chosen;
        unsound += admissible ? 0.0 : 1.0;
        density[i] = new_density;
        u_x[i] = v_x;
        u_y[i] = v_y;
        u_z[i] = v_z;
        temperature[i] = (kept * per_density) * (2.0 / 3.0);
    }
    keep_books(column, stage, gravity, dt);
    Ledger& books = fluid_.books_of(column);
    books.dual_energy_gain += fluid_.grid().dz * sum_in_lanes(corrected, nz);
    books.floor_gain += fluid_.grid().dz * sum_in_lanes(floored, nz);
    return unsound == 0.0;
}

void Carry::keep_books(std::int64_t column, const Stage& stage, double gravity, double dt) {
    const Grid& grid = fluid_.grid();
    const Fluid::Rates& rates = fluid_.rates;
    const auto at = [&](const std::vector<double>& of, std::int64_t i) {
        return of[static_cast<std::size_t>(grid.first(column) + i)];
    };
    Ledger rate;
    rate.body_force_work = -gravity * grid.dz * at(rates.mass, -1);
    rate.gravity_work = -fluid_.setup.gravity * grid.dz * at(rates.mass, -1);
    rate.boundary_gain = at(rates.energy, -1) - at(rates.energy, grid.nz);
    rate.plate_impulse = at(rates.momentum_z, -1);
    rate.lid_impulse = at(rates.momentum_z, grid.nz);
    Ledger& books = fluid_.books_of(column);
    const Ledger& base = base_books_[static_cast<std::size_t>(column)];
    books = stage.start * base + stage.previous * (books + dt * rate);
}

}  // namespace shaken::continuum
