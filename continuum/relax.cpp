// SPDX-License-Identifier: MIT
// The implicit and the exact part of a step: diffusion along the columns, cooling in the cells. They are one operator:
// where conduction along z crosses a cell in less than a step, cooling by itself and conduction by itself would leave
// a heated wall an error of first order in dt.
#include <algorithm>
#include <cmath>

#include "continuum/closures/pressure.hpp"
#include "continuum/diffusion_solve.hpp"
#include "continuum/evolution.hpp"
#include "continuum/flux/wave_speeds.hpp"
#include "continuum/heat_of_density.hpp"
#include "continuum/sum_in_lanes.hpp"

namespace shaken::continuum {

// All transport coefficients are a function of density times a power of T, and density does not change here: they are
// taken at T = 1, once for all pieces.
void Evolution::relax(double dt) {
    const bool cools = !(dissipation_.is_constant() && dissipation_.constant() == 0.0);
    if (!cools && !kernels_.viscous) return;
    const std::int64_t columns = grid().columns();
#pragma omp parallel for schedule(static) num_threads(threads())
    for (std::int64_t column = 0; column < columns; ++column) {
        double* ones = work_[thread()].row(0);
        std::fill(ones, ones + grid().nz, 1.0);
        kernels_.transport(flow().density.data() + grid().first(column), ones, coefficients(column), grid().nz,
                           constants_);
    }
    const bool horizontal = kernels_.viscous && columns > 1;
    const int pieces = horizontal ? pieces_of_relaxation(0.5 * dt) : 1;
    const double piece = dt / pieces;
    for (int i = 0; i < pieces; ++i) {
        if (horizontal) relax_horizontally(0.5 * piece);
        relax_columns(piece, cools);
        if (horizontal) relax_horizontally(0.5 * piece);
    }
    relaxations_ += pieces;
}

TransportArrays Evolution::coefficients(std::int64_t column) {
    const std::int64_t first = grid().first(column);
    return {coefficients_.bulk.data() + first, coefficients_.shear.data() + first,
            coefficients_.conductivity.data() + first, coefficients_.density_conductivity.data() + first,
            coefficients_.cooling.data() + first};
}

void Evolution::relax_columns(double dt, bool cools) {
#pragma omp parallel for schedule(static) num_threads(threads())
    for (std::int64_t column = 0; column < grid().columns(); ++column) {
        if (kernels_.viscous)
            cool_and_diffuse(column, dt, cools, work_[thread()]);
        else
            cool(column, dt);
    }
}

void Evolution::cool(std::int64_t column, double dt) {
    const std::int64_t nz = grid().nz, first = grid().first(column);
    const double* density = flow().density.data() + first;
    double* __restrict temperature = setup_.flow.temperature.data() + first;
    const double* rate = coefficients(column).cooling;
    const double floor = constants_.floor_temperature;
    double *__restrict lost = work_[thread()].row(0), *__restrict floored = work_[thread()].row(1);
    // d(T^(-1/2))/dt = rate D / 2 while D stays the same: exact for constant restitution, and second order in dt with D
    // taken at the middle of the step for the others.
    const auto cooled = [](double t, double half_rate) {
        const double root = 1.0 + half_rate * std::sqrt(t);
        return t / (root * root);
    };
    if (dissipation_.is_constant()) {
        const double half_step = 0.5 * dt * dissipation_.constant();
#pragma omp simd
        for (std::int64_t i = 0; i < nz; ++i) {
            const double new_temperature = cooled(temperature[i], half_step * rate[i]);
            const double kept = larger(floor, new_temperature);
            lost[i] = density[i] * (temperature[i] - new_temperature);
            floored[i] = density[i] * (kept - new_temperature);
            temperature[i] = kept;
        }
    } else {
        const double* table = dissipation_.table();
#pragma omp simd
        for (std::int64_t i = 0; i < nz; ++i) {
            const double t = temperature[i];
            const EffectiveDissipation::Local d = EffectiveDissipation::interpolate(table, t);
            // ln(T_middle/T) = -2 ln(1 + x), x over a quarter of the step's exponent, by its Pade approximant.
            const double x = (0.25 * dt * rate[i]) * (d.value * std::sqrt(t));
            const double at_middle = larger(d.value - d.slope * (4.0 * x / (2.0 + x)), 0.0);
            const double new_temperature = cooled(t, (0.5 * dt * rate[i]) * at_middle);
            const double kept = larger(floor, new_temperature);
            lost[i] = density[i] * (t - new_temperature);
            floored[i] = density[i] * (kept - new_temperature);
            temperature[i] = kept;
        }
    }
    Ledger& books = books_[static_cast<std::size_t>(column)];
    books.collisional_loss += 1.5 * grid().dz * sum_in_lanes(lost, nz);
    books.floor_gain += 1.5 * grid().dz * sum_in_lanes(floored, nz);
}

// Cooling, then backward Euler, over the step and over its two halves, extrapolated (Richardson): second order in dt,
// and a mode that decays as exp(-x) is multiplied by 2/(1 + x/2)^2 - 1/(1 + x), which goes to 0 for large x and is
// never below -0.036. With d = u_halves - u_whole the motion is u_halves + s d, and what keeps the total energy of each
// cell is
//     T_halves + s (T_halves - T_whole) - (s + s^2) d^2/3.
// s is 1 wherever that leaves each cell of the column at least half of T_halves; else the largest for which it does.
void Evolution::cool_and_diffuse(std::int64_t column, double dt, bool cools, Workspace& work) {
    const std::int64_t nz = grid().nz, first = grid().first(column);
    Flow& flow = setup_.flow;
    double* fields[4] = {flow.temperature.data() + first, flow.velocity_z.data() + first};
    std::size_t changing = 2;
    if (moves_along_x_) fields[changing++] = flow.velocity_x.data() + first;
    if (moves_along_y_) fields[changing++] = flow.velocity_y.data() + first;
    const auto whole = [&](std::size_t k) { return work.row(15 + k); };
    const auto start = [&](std::size_t k) { return work.row(19 + k); };
    for (std::size_t k = 0; k < changing; ++k) std::copy(fields[k], fields[k] + nz, start(k));
    Ledger& books = books_[static_cast<std::size_t>(column)];
    const Ledger books_before = books;
    cool_and_diffuse_once(column, dt, cools, work);
    const Ledger books_whole = books;
    books = books_before;
    for (std::size_t k = 0; k < changing; ++k) {
        std::copy(fields[k], fields[k] + nz, whole(k));
        std::copy(start(k), start(k) + nz, fields[k]);
    }
    cool_and_diffuse_once(column, 0.5 * dt, cools, work);
    cool_and_diffuse_once(column, 0.5 * dt, cools, work);

    double *squares = start(0), *t = fields[0];  // d^2/3
    const double* t_whole = whole(0);
    std::fill(squares, squares + nz, 0.0);
    // u_z last: a sum in which x and y can be exchanged without another rounding.
    for (std::size_t k = changing - 1; k >= 1; --k) {
        const double *u = fields[k], *u_whole = whole(k);
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
        const double* u_whole = whole(k);
        for (std::int64_t i = 0; i < nz; ++i) u[i] += s * (u[i] - u_whole[i]);
    }
    for (double Ledger::*entry : {&Ledger::collisional_loss, &Ledger::floor_gain, &Ledger::boundary_gain,
                                  &Ledger::plate_impulse, &Ledger::lid_impulse})
        books.*entry += s * (books.*entry - books_whole.*entry);
}

//  | cell 0 | cell 1 | ...     couplings w[0] w[1] ... w[nz] live on the faces; w[f] = dt coefficient / dz^2, the
//  w0       w1       w2        coefficient being the mean of its two cells. At a wall it is 2 dt coefficient / dz^2,
//                              the wall standing half a cell away. In a periodic column both ends are one face.
void Evolution::cool_and_diffuse_once(std::int64_t column, double dt, bool cools, Workspace& work) {
    if (cools) cool(column, dt);
    const std::int64_t nz = grid().nz, first = grid().first(column);
    const double dz = grid().dz;
    const double* density = flow().density.data() + first;
    double* temperature = setup_.flow.temperature.data() + first;
    const TransportArrays reduced = coefficients(column);
    double *axial = work.row(6), *shear = work.row(7), *conduction = work.row(8);
    double *coupling = work.row(9), *values = work.row(10), *heat = work.row(11), *ratio = work.row(12);
    const double scale = 0.5 * dt / (dz * dz);
#pragma omp simd
    for (std::int64_t i = 0; i < nz; ++i) {
        const double scaled_root = scale * std::sqrt(temperature[i]);
        axial[i] = scaled_root * (reduced.bulk[i] + (4.0 / 3.0) * reduced.shear[i]);
        shear[i] = scaled_root * reduced.shear[i];
        conduction[i] = scaled_root * reduced.conductivity[i];
        heat[i] = 0.0;
    }
    const bool ring = setup_.boundaries.lower.end == End::periodic;
    const auto couple = [&](const double* coefficient, bool lower_wall, bool upper_wall) {
#pragma omp simd
        for (std::int64_t f = 1; f < nz; ++f) coupling[f] = coefficient[f - 1] + coefficient[f];
        coupling[0] = lower_wall ? 4.0 * coefficient[0] : 0.0;
        coupling[nz] = upper_wall ? 4.0 * coefficient[nz - 1] : 0.0;
        if (ring) coupling[0] = coupling[nz] = coefficient[0] + coefficient[nz - 1];
    };
    const auto solve = [&](const double* capacity, const Couplings& couplings) {
        if (ring)
            solve_periodic_diffusion(nz, capacity, couplings, values, ratio, work.row(13), work.row(14));
        else
            solve_diffusion(nz, capacity, couplings, values, ratio);
    };
    const auto momentum = [&](const double* velocity, double* out) {
        for (std::int64_t i = 0; i < nz; ++i) out[i] = density[i] * velocity[i];
    };
    // The kinetic energy that momentum loses: w (du)^2 at each face, half to either cell, and n (u' - u)^2 / 2 in each
    // cell. Both are positive, and with u' they add up to the loss exactly.
    const auto take_over = [&](double* velocity, const double* diffused, double* into) {
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
    };
    const auto diffuse_one = [&](double* velocity, double* into) {
        momentum(velocity, values);
        solve(density, {coupling, coupling});
        take_over(velocity, values, into);
    };
    const Boundaries& ends = setup_.boundaries;
    Ledger& books = books_[static_cast<std::size_t>(column)];
    couple(axial, ends.lower.end == End::wall, ends.upper.end == End::wall);
    diffuse_one(setup_.flow.velocity_z.data() + first, heat);
    if (!ring) {
        books.plate_impulse -= dz * coupling[0] * values[0];
        books.lid_impulse += dz * coupling[nz] * values[nz - 1];
    }
    double *velocity_x = setup_.flow.velocity_x.data() + first, *velocity_y = setup_.flow.velocity_y.data() + first;
    double* heat_of_shear = work.row(3);  // apart: x and y can be exchanged without another rounding
    if (moves_along_x_ || moves_along_y_) {
        couple(shear, false, false);
        std::fill(heat_of_shear, heat_of_shear + nz, 0.0);
    }
    if (moves_along_x_ && moves_along_y_ && !ring) {
        double* values_y = axial;
        momentum(velocity_x, values);
        momentum(velocity_y, values_y);
        solve_diffusion(nz, density, Couplings{coupling, coupling}, std::array{values, values_y}, ratio);
        take_over(velocity_x, values, heat_of_shear);
        take_over(velocity_y, values_y, heat_of_shear);
    } else {
        if (moves_along_x_) diffuse_one(velocity_x, heat_of_shear);
        if (moves_along_y_) diffuse_one(velocity_y, heat_of_shear);
    }
    if (moves_along_x_ || moves_along_y_)
        for (std::int64_t i = 0; i < nz; ++i) heat[i] += heat_of_shear[i];

    const double lower_temperature = ends.lower.temperature.value_or(0.0);
    const double upper_temperature = ends.upper.temperature.value_or(0.0);
    couple(conduction, ends.lower.temperature.has_value(), ends.upper.temperature.has_value());
    double* capacity = heat;
#pragma omp simd
    for (std::int64_t i = 0; i < nz; ++i) {
        values[i] = 1.5 * density[i] * temperature[i] + heat[i];
        capacity[i] = 1.5 * density[i];
    }
    double *up = coupling, *down = coupling;
    if (kernels_.density_drives_heat) {
        up = work.row(1);
        down = work.row(2);
        const auto cell = [&](std::int64_t i) {
            return HeatCell{density[i], temperature[i], reduced.density_conductivity[i]};
        };
        for (std::int64_t f = ring ? 0 : 1; f < nz; ++f) {
            const HeatCouplings at = heat_couplings(cell(f > 0 ? f - 1 : nz - 1), cell(f), coupling[f], scale);
            up[f] = at.up;
            down[f] = at.down;
        }
        // A heated wall gives what the gradient beside it drives; through any other wall no heat passes.
        const auto wall = [&](std::int64_t at, std::int64_t next, double wall_temperature) {
            const double n = density[at], straight = 2.0 * n - density[next];
            const double beyond = larger(0.5 * n, smaller(straight, 1.5 * n));
            return HeatCell{beyond, wall_temperature, reduced.density_conductivity[at] * (n / beyond)};
        };
        if (ring) {
            up[nz] = up[0];
            down[nz] = down[0];
        } else {
            HeatCouplings lower{coupling[0], coupling[0]}, upper{coupling[nz], coupling[nz]};
            if (lower_temperature > 0.0)
                lower = heat_couplings(wall(0, 1, lower_temperature), cell(0), coupling[0], scale);
            if (upper_temperature > 0.0)
                upper = heat_couplings(cell(nz - 1), wall(nz - 1, nz - 2, upper_temperature), coupling[nz], scale);
            up[0] = lower.up;
            down[0] = lower.down;
            up[nz] = upper.up;
            down[nz] = upper.down;
        }
    }
    if (!ring) {
        values[0] += up[0] * lower_temperature;
        values[nz - 1] += down[nz] * upper_temperature;
    }
    solve(capacity, {up, down});
    if (!ring)
        books.boundary_gain += dz * ((up[0] * lower_temperature - down[0] * values[0]) +
                                     (down[nz] * upper_temperature - up[nz] * values[nz - 1]));
    for (std::int64_t i = 0; i < nz; ++i) temperature[i] = values[i];
}

}  // namespace shaken::continuum
