// SPDX-License-Identifier: MIT
// Viscosity and conduction across columns, and the stresses that mix directions; explicit, conservative, second order.
//     tau_ij = (lambda - 2 mu/3) div u delta_ij + mu (d_i u_j + d_j u_i)
// At a face normal to x all of tau_xj is taken here; at a face normal to z only what diffuse() leaves: the derivatives
// along x and y. Derivatives along a face are means over the cells on both sides.
// Explicit diffusion carries at most n dx^2/(4 dt) (two horizontal dimensions, /2 with one) through a face. Relaxation
// is cut into as many equal pieces as that asks for wherever the mean free path is below longest_free_path; in thinner
// gas, where these equations say nothing, the coefficients are capped instead. The mixed terms need no tighter bound
// there as long as each piece also has its implicit diffusion along z: with a = D dt/dx^2 and b = D dt/dz^2 a piece
// changes a disturbance by (1 - a + 2 sqrt(a b))/(1 + b) at most, and that is below one. Where coefficients are capped
// b is no longer that of the same D, and the mixed ones are held below n dx dz/(4 dt): without it thin gas above a
// falling crest was thrown about and took heat from nowhere. Heat along the density gradient is capped with conduction,
// by the same factor.
#include <algorithm>
#include <cmath>

#include "continuum/boundary/fill_ghosts.hpp"
#include "continuum/evolution.hpp"
#include "continuum/flux/wave_speeds.hpp"
#include "continuum/sum_in_lanes.hpp"

namespace shaken::continuum {

namespace {

// All horizontal faces of a cell together take at most this share of what would empty it.
constexpr double share_of_faces = 0.9;
// In sigma, at volume fraction 0.013: a third of where the layer is taken to end.
constexpr double longest_free_path = 8.0;
constexpr double thinnest_resolved = 0.19947114020071635 / longest_free_path;  // n = 1/(path sqrt(8 pi))
constexpr double most_pieces = 100.0;

/// What the stresses at a face carry: momentum along the face's normal, along it horizontally, along z, and energy.
struct Carried {
    double *normal, *lateral, *vertical, *energy;
};

/// The fields of one column, element 0 the lowest cell.
struct ColumnFields {
    const double *density, *normal, *lateral, *vertical, *temperature, *thermal_speed;
    const double *bulk, *shear, *conductivity, *density_conductivity;  // at T = 1
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
    const double mixed_cap = n.share * n.width * dz / dt;
#pragma omp simd
    for (std::int64_t k = 0; k < nz; ++k) {
        const double thinner = smaller(n.left.density[k], n.right.density[k]);
        const double most = cap * thinner;
        const double left = 0.5 * n.left.thermal_speed[k], right = 0.5 * n.right.thermal_speed[k];
        const double mean_shear = left * n.left.shear[k] + right * n.right.shear[k];
        const double mean_bulk = left * n.left.bulk[k] + right * n.right.bulk[k];
        const double shear = smaller(mean_shear, most), axial = smaller(mean_bulk + (4.0 / 3.0) * mean_shear, most);
        const double bulk = smaller(mean_bulk, most);
        const double most_mixed =
            mean_bulk + (4.0 / 3.0) * mean_shear <= most ? most : smaller(most, mixed_cap * thinner);
        const double mixed_shear = smaller(mean_shear, most_mixed), mixed_bulk = smaller(mean_bulk, most_mixed);
        const double mean_conductivity = left * n.left.conductivity[k] + right * n.right.conductivity[k];
        const double conductivity = smaller(mean_conductivity, 1.5 * most);

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

        // Heat along the density gradient, as in heat_of_density.hpp; less of it where there is less conduction.
        const double left_heat = left * n.left.temperature[k] * (n.left.density[k] * n.left.density_conductivity[k]);
        const double right_heat =
            right * n.right.temperature[k] * (n.right.density[k] * n.right.density_conductivity[k]);
        const double jump = 2.0 * (n.right.density[k] - n.left.density[k]);
        const double density_heat = (left_heat + right_heat) * (across * jump) *
                                    (conductivity / (mean_conductivity * (n.right.density[k] + n.left.density[k])));

        const double stress_normal = axial * normal_across + (bulk - (2.0 / 3.0) * shear) * lateral_along +
                                     (mixed_bulk - (2.0 / 3.0) * mixed_shear) * vertical_upward;
        const double stress_lateral = shear * lateral_across + shear * normal_along;
        const double stress_vertical = shear * vertical_across + mixed_shear * normal_upward;
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

double Evolution::share_of_face() const { return share_of_faces / (grid().nx > 1 && grid().ny > 1 ? 4.0 : 2.0); }

double Evolution::narrowest_square() const {
    const double width = smaller(grid().nx > 1 ? grid().dx : grid().dy, grid().ny > 1 ? grid().dy : grid().dx);
    return width * width;
}

int Evolution::pieces_of_relaxation(double dt) {
    const std::int64_t columns = grid().columns(), nz = grid().nz;
    double fastest = 0.0;  // kinematic viscosity or thermal diffusivity where it is resolved
#pragma omp parallel for schedule(static) num_threads(threads()) reduction(max : fastest)
    for (std::int64_t column = 0; column < columns; ++column) {
        const TransportArrays at = coefficients(column);
        const double* n = flow().density.data() + grid().first(column);
        const double* temperature = flow().temperature.data() + grid().first(column);
        double most = 0.0;
#pragma omp simd reduction(max : most)
        for (std::int64_t k = 0; k < nz; ++k) {
            const double axial = at.bulk[k] + (4.0 / 3.0) * at.shear[k];
            const double diffusivity =
                larger(axial, at.conductivity[k] * (1.0 / 1.5)) * std::sqrt(temperature[k]) / n[k];
            most = larger(most, n[k] > thinnest_resolved ? diffusivity : 0.0);
        }
        fastest = larger(fastest, most);
    }
    const double wanted = std::ceil(dt * fastest / (share_of_face() * narrowest_square()));
    return static_cast<int>(std::clamp(wanted, 1.0, most_pieces));
}

void Evolution::relax_horizontally(double dt) {
    const std::int64_t columns = grid().columns(), nz = grid().nz;
#pragma omp parallel num_threads(threads())
    {
        Workspace& work = work_[thread()];
#pragma omp for schedule(static)
        for (std::int64_t column = 0; column < columns; ++column) {
            fill_ghosts_of_stresses(setup_.flow, grid().first(column), nz, setup_.boundaries,
                                    constants_.packing_density);
            const double* temperature = flow().temperature.data() + grid().first(column);
            double* thermal_speed = thermal_speed_.data() + grid().first(column);
#pragma omp simd
            for (std::int64_t k = 0; k < nz; ++k) thermal_speed[k] = std::sqrt(temperature[k]);
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
    const double dz = grid().dz, share = share_of_face();
    const auto fields = [&](std::int64_t x, std::int64_t y, bool along_x) {
        const std::int64_t f = grid().first(grid().column((x + nx) % nx, (y + ny) % ny));
        const double *u_x = flow().velocity_x.data() + f, *u_y = flow().velocity_y.data() + f;
        return ColumnFields{flow().density.data() + f,
                            along_x ? u_x : u_y,
                            along_x ? u_y : u_x,
                            flow().velocity_z.data() + f,
                            flow().temperature.data() + f,
                            thermal_speed_.data() + f,
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

    // Faces normal to z: element k of each array of `face` is below cell k, from the derivatives along x and y at the
    // cells it parts.
    const ColumnFields here = fields(ix, iy, true), to_east = fields(ix + 1, iy, true),
                       to_west = fields(ix - 1, iy, true), to_north = fields(ix, iy + 1, true),
                       to_south = fields(ix, iy - 1, true);
    const double half_dx = 0.5 / grid().dx, half_dy = 0.5 / grid().dy;
    const double cap = share * narrowest_square() / dt, mixed_cap = share * std::sqrt(narrowest_square()) * dz / dt;
    const auto most_mixed = [&](double density, double bulk, double shear) {
        const double most = cap * density;
        return bulk + (4.0 / 3.0) * shear <= most ? most : smaller(most, mixed_cap * density);
    };
    double* __restrict divergence = work.row(20), * __restrict slope_x = work.row(21), * __restrict slope_y = work.row(22);
#pragma omp simd
    for (std::int64_t k = 0; k < nz; ++k) {
        divergence[k] =
            half_dx * (to_east.normal[k] - to_west.normal[k]) + half_dy * (to_north.lateral[k] - to_south.lateral[k]);
        slope_x[k] = half_dx * (to_east.vertical[k] - to_west.vertical[k]);
        slope_y[k] = half_dy * (to_north.vertical[k] - to_south.vertical[k]);
    }
    // Through the face between cells below and k of this column.
    const auto stress_between = [&](std::int64_t below, std::int64_t k) {
        const double speed_below = 0.5 * here.thermal_speed[below], speed = 0.5 * here.thermal_speed[k];
        const double mean_shear = speed_below * here.shear[below] + speed * here.shear[k];
        const double mean_bulk = speed_below * here.bulk[below] + speed * here.bulk[k];
        const double most = most_mixed(smaller(here.density[below], here.density[k]), mean_bulk, mean_shear);
        const double shear = smaller(mean_shear, most), bulk = smaller(mean_bulk, most);
        const double along_z = 0.5 * (bulk - (2.0 / 3.0) * shear) * (divergence[below] + divergence[k]);
        const double along_x = 0.5 * shear * (slope_x[below] + slope_x[k]);
        const double along_y = 0.5 * shear * (slope_y[below] + slope_y[k]);
        face.normal[k] = along_x;
        face.lateral[k] = along_y;
        face.vertical[k] = along_z;
        face.energy[k] =
            0.5 *
            (along_z * (here.vertical[below] + here.vertical[k]) +
             (along_x * (here.normal[below] + here.normal[k]) + along_y * (here.lateral[below] + here.lateral[k])));
    };
#pragma omp simd
    for (std::int64_t k = 1; k < nz; ++k) stress_between(k - 1, k);
    if (setup_.boundaries.lower.end == End::periodic) {
        stress_between(nz - 1, 0);
        for (double* row : {face.normal, face.lateral, face.vertical, face.energy}) row[nz] = row[0];
    } else {  // no shear and no work, the normal stress of the cell beside the end if the end bears one
        for (const std::int64_t f : {std::int64_t{0}, nz}) {
            const std::int64_t cell = f == 0 ? 0 : nz - 1;
            const End end = f == 0 ? setup_.boundaries.lower.end : setup_.boundaries.upper.end;
            const double speed = here.thermal_speed[cell];
            const double bulk = speed * here.bulk[cell], shear = speed * here.shear[cell];
            const double most = most_mixed(here.density[cell], bulk, shear);
            const double coefficient = smaller(bulk, most) - (2.0 / 3.0) * smaller(shear, most);
            face.normal[f] = face.lateral[f] = face.energy[f] = 0.0;
            face.vertical[f] = end == End::stress_free ? 0.0 : coefficient * divergence[cell];
        }
        Ledger& books = books_[static_cast<std::size_t>(column)];
        books.plate_impulse -= dt * face.vertical[0];
        books.lid_impulse -= dt * face.vertical[nz];
    }

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
    double *__restrict corrected = work_[thread()].row(0), *__restrict floored = work_[thread()].row(1);
#pragma omp simd
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
        corrected[k] = density[k] * (chosen - wanted);
        floored[k] = density[k] * (kept - chosen);
        u_x[k] += change_x;
        u_y[k] += change_y;
        u_z[k] += change_z;
        temperature[k] = kept;
    }
    Ledger& books = books_[static_cast<std::size_t>(column)];
    books.dual_energy_gain += 1.5 * grid().dz * sum_in_lanes(corrected, nz);
    books.floor_gain += 1.5 * grid().dz * sum_in_lanes(floored, nz);
}

}  // namespace shaken::continuum
