// SPDX-License-Identifier: MIT
#include "continuum/step/relax_column.hpp"

#include <algorithm>
#include <cmath>

#include "continuum/flux/wave_speeds.hpp"
#include "continuum/step/heat_of_density.hpp"

namespace shaken::continuum {

RelaxColumn::RelaxColumn(Fluid& fluid, Coefficients& coefficients)
    : fluid_(fluid), coefficients_(coefficients), scratch_(rows_of_threads<Scratch>(fluid)) {}

// Cooling, then backward Euler, over the step and over its two halves, extrapolated (Richardson): second order in dt,
// and a mode that decays as exp(-x) is multiplied by 2/(1 + x/2)^2 - 1/(1 + x), which goes to 0 for large x and is
// never below -0.036. With d = u_halves - u_whole the motion is u_halves + s d, and what keeps the total energy of each
// cell is
//     T_halves + s (T_halves - T_whole) - (s + s^2) d^2/3.
// s is 1 wherever that leaves each cell of the column at least half of T_halves; else the largest for which it does.
void RelaxColumn::cool_and_diffuse(std::int64_t column, double dt, bool cools) {
    const std::int64_t nz = fluid_.grid().nz, first = fluid_.grid().first(column);
    Flow& flow = fluid_.flow();
    double* fields[4] = {flow.temperature.data() + first, flow.velocity_z.data() + first};
    std::size_t changing = 2;
    if (fluid_.moves_along_x) fields[changing++] = flow.velocity_x.data() + first;
    if (fluid_.moves_along_y) fields[changing++] = flow.velocity_y.data() + first;
    FieldRows &start = scratch().start, &whole = scratch().whole;
    for (std::size_t k = 0; k < changing; ++k) std::copy(fields[k], fields[k] + nz, start[k]);
    Ledger& books = fluid_.books_of(column);
    const Ledger books_before = books;
    cool_and_diffuse_once(column, dt, cools);
    const Ledger books_whole = books;
    books = books_before;
    for (std::size_t k = 0; k < changing; ++k) {
        std::copy(fields[k], fields[k] + nz, whole[k]);
        std::copy(start[k], start[k] + nz, fields[k]);
    }
    cool_and_diffuse_once(column, 0.5 * dt, cools);
    cool_and_diffuse_once(column, 0.5 * dt, cools);

    double *squares = start[0], *t = fields[0];  // d^2/3
    const double* t_whole = whole[0];
    std::fill(squares, squares + nz, 0.0);
    // u_z last: a sum in which x and y can be exchanged without another rounding.
    for (std::size_t k = changing - 1; k >= 1; --k) {
        const double *u = fields[k], *u_whole = whole[k];
        for (std::int64_t i = 0; i < nz; ++i) squares[i] += (1.0 / 3.0) * ((u[i] - u_whole[i]) * (u[i] - u_whole[i]));
    }
    double most = 0.0;  // of what s = 1 takes, as a share of half the temperature
    for (std::int64_t i = 0; i < nz; ++i) {
        const double taken = t_whole[i] - t[i] + 2.0 * squares[i];
        most = larger(most, taken / (0.5 * t[i]));
    }
    const double s = most > 1.0 ? 1.0 / most : 1.0;
    for (std::int64_t i = 0; i < nz; ++i) t[i] += s * (t[i] - t_whole[i]) - (s + s * s) * squares[i];
    for (std::size_t k = 1; k < changing; ++k) {
        double* u = fields[k];
        const double* u_whole = whole[k];
        for (std::int64_t i = 0; i < nz; ++i) u[i] += s * (u[i] - u_whole[i]);
    }
    books += s * (books - books_whole);
}

//  | cell 0 | cell 1 | ...     couplings w[0] w[1] ... w[nz] live on the faces; w[f] = dt coefficient / dz^2, the
//  w0       w1       w2        coefficient being the mean of its two cells. At a wall it is 2 dt coefficient / dz^2,
//                              the wall standing half a cell away. In a periodic column both ends are one face.
void RelaxColumn::cool_and_diffuse_once(std::int64_t column, double dt, bool cools) {
    if (cools) cool(column, dt);
    const std::int64_t nz = fluid_.grid().nz, first = fluid_.grid().first(column);
    const double* temperature = fluid_.flow().temperature.data() + first;
    const TransportArrays reduced = coefficients_.from(first);
    Scratch& s = scratch();
    double *axial = s.axial, *shear = s.shear, *conduction = s.conduction, *heat = s.heat;
    const double scale = 0.5 * dt / (fluid_.grid().dz * fluid_.grid().dz);
#pragma omp simd
    for (std::int64_t i = 0; i < nz; ++i) {
        const double scaled_root = scale * std::sqrt(temperature[i]);
        axial[i] = scaled_root * (reduced.bulk[i] + (4.0 / 3.0) * reduced.shear[i]);
        shear[i] = scaled_root * reduced.shear[i];
        conduction[i] = scaled_root * reduced.conductivity[i];
        heat[i] = 0.0;
    }
    diffuse_velocities(column);
    diffuse_temperature(column, scale);
}

void RelaxColumn::couple(const double* coefficient, bool lower_wall, bool upper_wall) {
    const std::int64_t nz = fluid_.grid().nz;
    double* coupling = scratch().coupling;
#pragma omp simd
    for (std::int64_t f = 1; f < nz; ++f) coupling[f] = coefficient[f - 1] + coefficient[f];
    coupling[0] = lower_wall ? 4.0 * coefficient[0] : 0.0;
    coupling[nz] = upper_wall ? 4.0 * coefficient[nz - 1] : 0.0;
    if (is_ring()) coupling[0] = coupling[nz] = coefficient[0] + coefficient[nz - 1];
}

void RelaxColumn::solve(const double* capacity, const Couplings& couplings) {
    Scratch& s = scratch();
    if (is_ring())
        solve_periodic_diffusion(fluid_.grid().nz, capacity, couplings, s.values, s.ratio, s.of_first, s.of_last);
    else
        solve_diffusion(fluid_.grid().nz, capacity, couplings, s.values, s.ratio);
}

// The kinetic energy that momentum loses: w (du)^2 at each face, half to either cell, and n (u' - u)^2 / 2 in each
// cell. Both are positive, and with u' they add up to the loss exactly.
void RelaxColumn::take_over(const double* density, double* velocity, const double* diffused, double* into) {
    const std::int64_t nz = fluid_.grid().nz;
    const bool ring = is_ring();
    const double* coupling = scratch().coupling;
    const double beneath = ring ? diffused[nz - 1] : diffused[0], beyond = ring ? diffused[0] : diffused[nz - 1];
#pragma omp simd
    for (std::int64_t i = 0; i < nz; ++i) {
        const double below = diffused[i] - (i > 0 ? diffused[i - 1] : beneath);
        const double above = (i < nz - 1 ? diffused[i + 1] : beyond) - diffused[i];
        const double change = diffused[i] - velocity[i];
        into[i] += 0.5 * ((coupling[i] * (below * below) + coupling[i + 1] * (above * above)) +
                          density[i] * (change * change));
    }
    if (!ring) {
        into[0] += coupling[0] * (diffused[0] * diffused[0]);
        into[nz - 1] += coupling[nz] * (diffused[nz - 1] * diffused[nz - 1]);
    }
    for (std::int64_t i = 0; i < nz; ++i) velocity[i] = diffused[i];
}

void RelaxColumn::diffuse_velocities(std::int64_t column) {
    const std::int64_t nz = fluid_.grid().nz, first = fluid_.grid().first(column);
    const double dz = fluid_.grid().dz;
    const double* density = fluid_.flow().density.data() + first;
    double *velocity_x = fluid_.flow().velocity_x.data() + first, *velocity_y = fluid_.flow().velocity_y.data() + first;
    const Boundaries& ends = fluid_.setup.boundaries;
    Scratch& s = scratch();
    double *coupling = s.coupling, *values = s.values, *heat = s.heat, *heat_of_shear = s.heat_of_shear;
    const auto momentum = [&](const double* velocity, double* out) {
        for (std::int64_t i = 0; i < nz; ++i) out[i] = density[i] * velocity[i];
    };
    const auto diffuse_one = [&](double* velocity, double* into) {
        momentum(velocity, values);
        solve(density, {coupling, coupling});
        take_over(density, velocity, values, into);
    };
    couple(s.axial, ends.lower.end == End::wall, ends.upper.end == End::wall);
    diffuse_one(fluid_.flow().velocity_z.data() + first, heat);
    if (!is_ring()) {
        Ledger& books = fluid_.books_of(column);
        books.plate_impulse -= dz * coupling[0] * values[0];
        books.lid_impulse += dz * coupling[nz] * values[nz - 1];
    }
    const bool along_x = fluid_.moves_along_x, along_y = fluid_.moves_along_y;
    if (!along_x && !along_y) return;
    couple(s.shear, false, false);
    // Their heat apart: x and y can be exchanged without another rounding.
    std::fill(heat_of_shear, heat_of_shear + nz, 0.0);
    if (along_x && along_y && !is_ring()) {
        double* values_y = s.values_y;
        momentum(velocity_x, values);
        momentum(velocity_y, values_y);
        solve_diffusion(nz, density, Couplings{coupling, coupling}, std::array{values, values_y}, s.ratio);
        take_over(density, velocity_x, values, heat_of_shear);
        take_over(density, velocity_y, values_y, heat_of_shear);
    } else {
        if (along_x) diffuse_one(velocity_x, heat_of_shear);
        if (along_y) diffuse_one(velocity_y, heat_of_shear);
    }
    for (std::int64_t i = 0; i < nz; ++i) heat[i] += heat_of_shear[i];
}

void RelaxColumn::diffuse_temperature(std::int64_t column, double scale) {
    const std::int64_t nz = fluid_.grid().nz, first = fluid_.grid().first(column);
    const double dz = fluid_.grid().dz;
    const double* density = fluid_.flow().density.data() + first;
    double* temperature = fluid_.flow().temperature.data() + first;
    const Boundaries& ends = fluid_.setup.boundaries;
    Scratch& s = scratch();
    couple(s.conduction, ends.lower.temperature.has_value(), ends.upper.temperature.has_value());
    double *values = s.values, *heat = s.heat,
           *capacity = s.heat;  // each cell's heat is spent before its place is taken
#pragma omp simd
    for (std::int64_t i = 0; i < nz; ++i) {
        values[i] = 1.5 * density[i] * temperature[i] + heat[i];
        capacity[i] = 1.5 * density[i];
    }
    double *up = s.coupling, *down = s.coupling;
    if (fluid_.kernels.density_drives_heat) {
        add_heat_of_density(column, scale);
        up = s.up;
        down = s.down;
    }
    const double lower_temperature = ends.lower.temperature.value_or(0.0);
    const double upper_temperature = ends.upper.temperature.value_or(0.0);
    if (!is_ring()) {
        values[0] += up[0] * lower_temperature;
        values[nz - 1] += down[nz] * upper_temperature;
    }
    solve(capacity, {up, down});
    if (!is_ring())
        fluid_.books_of(column).boundary_gain += dz * ((up[0] * lower_temperature - down[0] * values[0]) +
                                                       (down[nz] * upper_temperature - up[nz] * values[nz - 1]));
    for (std::int64_t i = 0; i < nz; ++i) temperature[i] = values[i];
}

/// Fills up and down: what conduction carries through the faces, and what the density gradient drives.
void RelaxColumn::add_heat_of_density(std::int64_t column, double scale) {
    const std::int64_t nz = fluid_.grid().nz, first = fluid_.grid().first(column);
    const double* density = fluid_.flow().density.data() + first;
    const double* temperature = fluid_.flow().temperature.data() + first;
    const double* conductivity = coefficients_.from(first).density_conductivity;
    const Boundaries& ends = fluid_.setup.boundaries;
    Scratch& s = scratch();
    double *coupling = s.coupling, *up = s.up, *down = s.down;
    const auto put = [&](std::int64_t face, const HeatCouplings& at) {
        up[face] = at.up;
        down[face] = at.down;
    };
    const auto cell = [&](std::int64_t i) { return HeatCell{density[i], temperature[i], conductivity[i]}; };
    for (std::int64_t f = 1; f < nz; ++f) put(f, heat_couplings(cell(f - 1), cell(f), coupling[f], scale));
    if (is_ring()) {
        put(0, heat_couplings(cell(nz - 1), cell(0), coupling[0], scale));
        put(nz, {up[0], down[0]});
        return;
    }
    // A heated wall gives what the gradient beside it drives; through any other wall no heat passes.
    const auto wall = [&](std::int64_t at, std::int64_t next, double wall_temperature) {
        const double n = density[at], straight = 2.0 * n - density[next];
        const double beyond = larger(0.5 * n, smaller(straight, 1.5 * n));
        return HeatCell{beyond, wall_temperature, conductivity[at] * (n / beyond)};
    };
    put(0, {coupling[0], coupling[0]});
    put(nz, {coupling[nz], coupling[nz]});
    if (ends.lower.temperature)
        put(0, heat_couplings(wall(0, 1, *ends.lower.temperature), cell(0), coupling[0], scale));
    if (ends.upper.temperature)
        put(nz, heat_couplings(cell(nz - 1), wall(nz - 1, nz - 2, *ends.upper.temperature), coupling[nz], scale));
}

}  // namespace shaken::continuum
