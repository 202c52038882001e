// SPDX-License-Identifier: MIT
// Viscosity and conduction across columns, and the stresses that mix directions; explicit, conservative, second order.
//     tau_ij = (lambda - 2 mu/3) div u delta_ij + mu (d_i u_j + d_j u_i)
// At a face normal to x all of tau_xj is taken here; at a face normal to z only what diffuse() leaves: the derivatives
// along x and y. Derivatives along a face are means over the cells on both sides.
// Coefficients are capped where a step would carry more than a face's share of the thinner cell: by n dx^2/(4 dt) (two
// horizontal dimensions, /2 with one) for the differences across a face, by n dx dz/(4 dt) for the mixed ones. At dx =
// 2, dz = 0.2 and the steps of a shaken layer that is a kinematic viscosity of 10 to 50, met above the layer only,
// where the mean free path is longer than a cell is wide and these equations say nothing anyway.
#include <cmath>

#include "continuum/boundary/fill_ghosts.hpp"
#include "continuum/evolution.hpp"
#include "continuum/flux/wave_speeds.hpp"

namespace shaken::continuum {

namespace {

// All horizontal faces of a cell together take at most this share of what would empty it.
constexpr double share_of_faces = 0.9;
constexpr double share_of_mixed = 1.0 / 4.0;

/// What the stresses at a face carry: momentum along the face's normal, along it horizontally, along z, and energy.
struct Carried {
    double *normal, *lateral, *vertical, *energy;
};

/// The fields of one column, element 0 the lowest cell.
struct ColumnFields {
    const double *density, *normal, *lateral, *vertical, *temperature;
    const double *bulk, *shear, *conductivity, *density_conductivity;
};

/// Face between columns `left` and `right` of a row; the lateral neighbours of either give the derivative along it.
struct Neighbourhood {
    ColumnFields left, right;
    ColumnFields left_before, left_after, right_before, right_after;
    double width, lateral_width;
    double share;  // of a face
};

void stresses_between(const Neighbourhood& at, double dz, double dt, std::int64_t nz, const Carried& out) {
    const Neighbourhood n = at;
    double* __restrict normal = out.normal, * __restrict lateral = out.lateral, * __restrict vertical = out.vertical, * __restrict energy = out.energy;
    const double across = 1.0 / n.width, along = 0.25 / n.lateral_width, upward = 0.25 / dz;
    const double cap = n.share * n.width * n.width / dt;
    const double heat_cap = 0.15 * n.width / dt;
    const double cap_mixed = share_of_mixed * n.width * dz / dt;
#pragma omp simd
    for (std::int64_t k = 0; k < nz; ++k) {
        const double thinner = smaller(n.left.density[k], n.right.density[k]);
        const double most = cap * thinner, most_mixed = cap_mixed * thinner;
        const double mean_shear = 0.5 * (n.left.shear[k] + n.right.shear[k]);
        const double mean_bulk = 0.5 * (n.left.bulk[k] + n.right.bulk[k]);
        const double shear = smaller(mean_shear, most), axial = smaller(mean_bulk + (4.0 / 3.0) * mean_shear, most);
        const double shear_mixed = smaller(mean_shear, most_mixed), bulk_mixed = smaller(mean_bulk, most_mixed);
        const double conductivity = smaller(0.5 * (n.left.conductivity[k] + n.right.conductivity[k]), 1.5 * most);

        const double normal_across = across * (n.right.normal[k] - n.left.normal[k]);
        const double lateral_across = across * (n.right.lateral[k] - n.left.lateral[k]);
        const double vertical_across = across * (n.right.vertical[k] - n.left.vertical[k]);
        const double normal_along = along * ((n.left_after.normal[k] - n.left_before.normal[k]) +
                                             (n.right_after.normal[k] - n.right_before.normal[k]));
        const double lateral_along = along * ((n.left_after.lateral[k] - n.left_before.lateral[k]) +
                                              (n.right_after.lateral[k] - n.right_before.lateral[k]));
        const double normal_upward =
            upward * ((n.left.normal[k + 1] - n.left.normal[k - 1]) + (n.right.normal[k + 1] - n.right.normal[k - 1]));
        const double vertical_upward = upward * ((n.left.vertical[k + 1] - n.left.vertical[k - 1]) +
                                                 (n.right.vertical[k + 1] - n.right.vertical[k - 1]));

        // Heat along the density gradient, at most a tenth of the poorer cell's a step.
        const double heat_limit =
            heat_cap * smaller(n.left.density[k] * n.left.temperature[k], n.right.density[k] * n.right.temperature[k]);
        const double density_wanted = 0.5 * (n.left.density_conductivity[k] + n.right.density_conductivity[k]) *
                                      (across * (n.right.density[k] - n.left.density[k]));
        const double density_heat = smaller(larger(density_wanted, -heat_limit), heat_limit);

        const double stress_normal =
            axial * normal_across + (bulk_mixed - (2.0 / 3.0) * shear_mixed) * (lateral_along + vertical_upward);
        const double stress_lateral = shear * lateral_across + shear_mixed * normal_along;
        const double stress_vertical = shear * vertical_across + shear_mixed * normal_upward;
        normal[k] = stress_normal;
        lateral[k] = stress_lateral;
        vertical[k] = stress_vertical;
        energy[k] = 0.5 * (stress_vertical * (n.left.vertical[k] + n.right.vertical[k]) +
                           (stress_normal * (n.left.normal[k] + n.right.normal[k]) +
                            stress_lateral * (n.left.lateral[k] + n.right.lateral[k]))) +
                    conductivity * (across * (n.right.temperature[k] - n.left.temperature[k])) + density_heat;
    }
}

}  // namespace

void Evolution::relax_horizontally(double dt) {
    const std::int64_t columns = grid().columns(), nz = grid().nz;
#pragma omp parallel num_threads(threads())
    {
        Workspace& work = work_[thread()];
#pragma omp for schedule(static)
        for (std::int64_t column = 0; column < columns; ++column) {
            const std::int64_t first = grid().first(column);
            fill_ghosts(setup_.flow, first, nz, setup_.boundaries, constants_.packing_density);
            const TransportArrays out{coefficients_.bulk.data() + first, coefficients_.shear.data() + first,
                                      coefficients_.conductivity.data() + first,
                                      coefficients_.density_conductivity.data() + first, work.row(0)};
            kernels_.transport(flow().density.data() + first, flow().temperature.data() + first, out, nz, constants_);
        }
#pragma omp for schedule(static)
        for (std::int64_t column = 0; column < columns; ++column) horizontal_stresses(column, dt, work);
#pragma omp for schedule(static)
        for (std::int64_t column = 0; column < columns; ++column) apply_horizontal_stresses(column, dt);
    }
}

void Evolution::horizontal_stresses(std::int64_t column, double dt, Workspace& work) {
    const std::int64_t nx = grid().nx, ny = grid().ny, nz = grid().nz, first = grid().first(column);
    const std::int64_t ix = column % nx, iy = column / nx;
    const double dz = grid().dz, share = share_of_faces / (nx > 1 && ny > 1 ? 4.0 : 2.0);
    const auto fields = [&](std::int64_t x, std::int64_t y, bool along_x) {
        const std::int64_t f = grid().first(grid().column((x + nx) % nx, (y + ny) % ny));
        const double *u_x = flow().velocity_x.data() + f, *u_y = flow().velocity_y.data() + f;
        return ColumnFields{flow().density.data() + f,
                            along_x ? u_x : u_y,
                            along_x ? u_y : u_x,
                            flow().velocity_z.data() + f,
                            flow().temperature.data() + f,
                            coefficients_.bulk.data() + f,
                            coefficients_.shear.data() + f,
                            coefficients_.conductivity.data() + f,
                            coefficients_.density_conductivity.data() + f};
    };
    const auto carried = [&](std::size_t set) {
        return Carried{work.row(4 * set), work.row(4 * set + 1), work.row(4 * set + 2), work.row(4 * set + 3)};
    };
    const Carried west = carried(0), east = carried(1), south = carried(2), north = carried(3), face = carried(4);
    const auto between_x = [&](std::int64_t x, const Carried& out) {  // columns x and x + 1
        stresses_between(
            {fields(x, iy, true), fields(x + 1, iy, true), fields(x, iy - 1, true), fields(x, iy + 1, true),
             fields(x + 1, iy - 1, true), fields(x + 1, iy + 1, true), grid().dx, grid().dy, share},
            dz, dt, nz, out);
    };
    const auto between_y = [&](std::int64_t y, const Carried& out) {
        stresses_between(
            {fields(ix, y, false), fields(ix, y + 1, false), fields(ix - 1, y, false), fields(ix + 1, y, false),
             fields(ix - 1, y + 1, false), fields(ix + 1, y + 1, false), grid().dy, grid().dx, share},
            dz, dt, nz, out);
    };
    between_x(ix - 1, west);
    between_x(ix, east);
    between_y(iy - 1, south);
    between_y(iy, north);

    // Faces normal to z: face.xxx[k] below cell k, from the derivatives along x and y at the cells it parts.
    const ColumnFields here = fields(ix, iy, true), to_east = fields(ix + 1, iy, true),
                       to_west = fields(ix - 1, iy, true), to_north = fields(ix, iy + 1, true),
                       to_south = fields(ix, iy - 1, true);
    const double half_dx = 0.5 / grid().dx, half_dy = 0.5 / grid().dy;
    const double cap =
        share_of_mixed * dz / dt * smaller(nx > 1 ? grid().dx : grid().dy, ny > 1 ? grid().dy : grid().dx);
    double* __restrict divergence = work.row(20), * __restrict slope_x = work.row(21), * __restrict slope_y = work.row(22);
#pragma omp simd
    for (std::int64_t k = 0; k < nz; ++k) {
        divergence[k] =
            half_dx * (to_east.normal[k] - to_west.normal[k]) + half_dy * (to_north.lateral[k] - to_south.lateral[k]);
        slope_x[k] = half_dx * (to_east.vertical[k] - to_west.vertical[k]);
        slope_y[k] = half_dy * (to_north.vertical[k] - to_south.vertical[k]);
    }
#pragma omp simd
    for (std::int64_t k = 1; k < nz; ++k) {
        const double most = cap * smaller(here.density[k - 1], here.density[k]);
        const double shear = smaller(0.5 * (here.shear[k - 1] + here.shear[k]), most);
        const double bulk = smaller(0.5 * (here.bulk[k - 1] + here.bulk[k]), most);
        const double along_z = 0.5 * (bulk - (2.0 / 3.0) * shear) * (divergence[k - 1] + divergence[k]);
        const double along_x = 0.5 * shear * (slope_x[k - 1] + slope_x[k]);
        const double along_y = 0.5 * shear * (slope_y[k - 1] + slope_y[k]);
        face.normal[k] = along_x;
        face.lateral[k] = along_y;
        face.vertical[k] = along_z;
        face.energy[k] =
            0.5 *
            (along_z * (here.vertical[k - 1] + here.vertical[k]) +
             (along_x * (here.normal[k - 1] + here.normal[k]) + along_y * (here.lateral[k - 1] + here.lateral[k])));
    }
    // At the ends: no shear and no work, the normal stress of the cell beside it.
    for (const std::int64_t f : {std::int64_t{0}, nz}) {
        const std::int64_t cell = f == 0 ? 0 : nz - 1;
        const double most = cap * here.density[cell];
        const double coefficient = smaller(here.bulk[cell], most) - (2.0 / 3.0) * smaller(here.shear[cell], most);
        face.normal[f] = face.lateral[f] = face.energy[f] = 0.0;
        face.vertical[f] = coefficient * divergence[cell];
    }
    Ledger& books = books_[static_cast<std::size_t>(column)];
    books.plate_impulse -= dt * face.vertical[0];
    books.lid_impulse -= dt * face.vertical[nz];

    const double per_dx = 1.0 / grid().dx, per_dy = 1.0 / grid().dy, per_dz = 1.0 / dz;
    double *__restrict momentum_x = rates_.momentum_x.data() + first, *__restrict momentum_y = rates_.momentum_y.data() + first,
                       *__restrict momentum_z = rates_.momentum_z.data() + first,
                       *__restrict energy = rates_.energy.data() + first;
#pragma omp simd
    for (std::int64_t k = 0; k < nz; ++k) {
        momentum_x[k] = per_dz * (face.normal[k + 1] - face.normal[k]) +
                        (per_dx * (east.normal[k] - west.normal[k]) + per_dy * (north.lateral[k] - south.lateral[k]));
        momentum_y[k] = per_dz * (face.lateral[k + 1] - face.lateral[k]) +
                        (per_dx * (east.lateral[k] - west.lateral[k]) + per_dy * (north.normal[k] - south.normal[k]));
        momentum_z[k] =
            per_dz * (face.vertical[k + 1] - face.vertical[k]) +
            (per_dx * (east.vertical[k] - west.vertical[k]) + per_dy * (north.vertical[k] - south.vertical[k]));
        energy[k] = per_dz * (face.energy[k + 1] - face.energy[k]) +
                    (per_dx * (east.energy[k] - west.energy[k]) + per_dy * (north.energy[k] - south.energy[k]));
    }
}

void Evolution::apply_horizontal_stresses(std::int64_t column, double dt) {
    const std::int64_t nz = grid().nz, first = grid().first(column);
    const double floor = constants_.floor_temperature;
    const double* density = flow().density.data() + first;
    double *__restrict u_x = setup_.flow.velocity_x.data() + first, *__restrict u_y = setup_.flow.velocity_y.data() + first,
                       *__restrict u_z = setup_.flow.velocity_z.data() + first,
                       *__restrict temperature = setup_.flow.temperature.data() + first;
    const double *momentum_x = rates_.momentum_x.data() + first, *momentum_y = rates_.momentum_y.data() + first,
                 *momentum_z = rates_.momentum_z.data() + first, *energy = rates_.energy.data() + first;
    double corrected = 0.0, floored = 0.0;
#pragma omp simd reduction(+ : corrected, floored)
    for (std::int64_t k = 0; k < nz; ++k) {
        const double step = dt / density[k];
        const double change_x = step * momentum_x[k], change_y = step * momentum_y[k], change_z = step * momentum_z[k];
        // Heat is what the energy gains and the motion does not: u . du + du^2/2 of it goes to the motion.
        const double motion = change_z * (u_z[k] + 0.5 * change_z) +
                              (change_x * (u_x[k] + 0.5 * change_x) + change_y * (u_y[k] + 0.5 * change_y));
        const double gained = (2.0 / 3.0) * (step * energy[k] - motion);
        // The mixed terms may take heat in one part of a step that another gives back; never more than half of it.
        const double wanted = temperature[k] + gained;
        const double chosen = larger(0.5 * temperature[k], wanted);
        const double kept = larger(floor, chosen);
        corrected += density[k] * (chosen - wanted);
        floored += density[k] * (kept - chosen);
        u_x[k] += change_x;
        u_y[k] += change_y;
        u_z[k] += change_z;
        temperature[k] = kept;
    }
    Ledger& books = books_[static_cast<std::size_t>(column)];
    books.dual_energy_gain += 1.5 * grid().dz * corrected;
    books.floor_gain += 1.5 * grid().dz * floored;
}

}  // namespace shaken::continuum
