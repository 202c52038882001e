// SPDX-License-Identifier: MIT
#include "continuum/step/relax_horizontal.hpp"

#include <algorithm>
#include <cmath>

#include "continuum/boundary/fill_ghosts.hpp"
#include "continuum/flux/wave_speeds.hpp"
#include "continuum/step/sum_in_lanes.hpp"

namespace shaken::continuum {

namespace {

// All horizontal faces of a cell together take at most this share of what would empty it.
constexpr double share_of_faces = 0.9;
// In sigma, at volume fraction 0.013: a third of where the layer is taken to end.
constexpr double longest_free_path = 8.0;
constexpr double thinnest_resolved = 0.19947114020071635 / longest_free_path;  // n = 1/(path sqrt(8 pi))
constexpr double most_pieces = 100.0;

}  // namespace

RelaxHorizontal::RelaxHorizontal(Fluid& fluid, Coefficients& coefficients)
    : fluid_(fluid),
      coefficients_(coefficients),
      thermal_speed_(fluid.grid().columns() > 1 ? fluid.grid().size() : 0, 0.0),
      scratch_(rows_of_threads<Scratch>(fluid)) {}

double RelaxHorizontal::share_of_face() const {
    return share_of_faces / (fluid_.grid().nx > 1 && fluid_.grid().ny > 1 ? 4.0 : 2.0);
}

double RelaxHorizontal::narrowest_square() const {
    const double width = smaller(fluid_.grid().nx > 1 ? fluid_.grid().dx : fluid_.grid().dy,
                                 fluid_.grid().ny > 1 ? fluid_.grid().dy : fluid_.grid().dx);
    return width * width;
}

int RelaxHorizontal::pieces(double dt) const {
    const std::int64_t columns = fluid_.grid().columns(), nz = fluid_.grid().nz;
    double fastest = 0.0;  // kinematic viscosity or thermal diffusivity where it is resolved
#pragma omp parallel for schedule(static) num_threads(fluid_.threads()) reduction(max : fastest)
    for (std::int64_t column = 0; column < columns; ++column) {
        const TransportArrays at = coefficients_.from(fluid_.grid().first(column));
        const double* n = fluid_.flow().density.data() + fluid_.grid().first(column);
        const double* temperature = fluid_.flow().temperature.data() + fluid_.grid().first(column);
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

void RelaxHorizontal::operator()(double dt) {
    const std::int64_t columns = fluid_.grid().columns(), nz = fluid_.grid().nz;
#pragma omp parallel num_threads(fluid_.threads())
    {
#pragma omp for schedule(static)
        for (std::int64_t column = 0; column < columns; ++column) {
            fill_ghosts_of_stresses(fluid_.flow(), fluid_.grid().first(column), nz, fluid_.setup.boundaries,
                                    fluid_.constants.packing_density);
            const double* temperature = fluid_.flow().temperature.data() + fluid_.grid().first(column);
            double* thermal_speed = thermal_speed_.data() + fluid_.grid().first(column);
#pragma omp simd
            for (std::int64_t k = 0; k < nz; ++k) thermal_speed[k] = std::sqrt(temperature[k]);
        }
#pragma omp for schedule(static)
        for (std::int64_t column = 0; column < columns; ++column) {
            stresses_of_sides(column, dt);
            stresses_of_faces(column, dt);
            sum_stresses(column);
        }
#pragma omp for schedule(static)
        for (std::int64_t column = 0; column < columns; ++column) apply(column, dt);
    }
}

/// Of the column at (x, y), wrapped around, with the velocities as a face normal to x (or to y) names them.
ColumnFields RelaxHorizontal::fields(std::int64_t x, std::int64_t y, bool along_x) const {
    const Grid& grid = fluid_.grid();
    const Flow& flow = fluid_.flow();
    const std::int64_t f = grid.first(grid.column((x + grid.nx) % grid.nx, (y + grid.ny) % grid.ny));
    const double *u_x = flow.velocity_x.data() + f, *u_y = flow.velocity_y.data() + f;
    return {flow.density.data() + f,
            along_x ? u_x : u_y,
            along_x ? u_y : u_x,
            flow.velocity_z.data() + f,
            flow.temperature.data() + f,
            thermal_speed_.data() + f,
            coefficients_.bulk.data() + f,
            coefficients_.shear.data() + f,
            coefficients_.conductivity.data() + f,
            coefficients_.density_conductivity.data() + f};
}

void RelaxHorizontal::stresses_of_sides(std::int64_t column, double dt) {
    const Grid& grid = fluid_.grid();
    const std::int64_t ix = column % grid.nx, iy = column / grid.nx;
    const double share = share_of_face();
    const auto between_x = [&](std::int64_t x, CarriedRows& out) {  // columns x and x + 1
        stresses_between(
            {fields(x, iy, true), fields(x + 1, iy, true), fields(x, iy - 1, true), fields(x, iy + 1, true),
             fields(x + 1, iy - 1, true), fields(x + 1, iy + 1, true), grid.dx, grid.dy, share},
            grid.dz, dt, grid.nz, out.arrays());
    };
    const auto between_y = [&](std::int64_t y, CarriedRows& out) {
        stresses_between(
            {fields(ix, y, false), fields(ix, y + 1, false), fields(ix - 1, y, false), fields(ix + 1, y, false),
             fields(ix - 1, y + 1, false), fields(ix + 1, y + 1, false), grid.dy, grid.dx, share},
            grid.dz, dt, grid.nz, out.arrays());
    };
    Scratch& s = scratch_[thread()];
    between_x(ix - 1, s.west);
    between_x(ix, s.east);
    between_y(iy - 1, s.south);
    between_y(iy, s.north);
}

// Faces normal to z: element k of each array of `face` is below cell k, from the derivatives along x and y at the
// cells it parts.
void RelaxHorizontal::stresses_of_faces(std::int64_t column, double dt) {
    const Grid& grid = fluid_.grid();
    const std::int64_t ix = column % grid.nx, iy = column / grid.nx, nz = grid.nz;
    const double dz = grid.dz, share = share_of_face();
    const ColumnFields here = fields(ix, iy, true), to_east = fields(ix + 1, iy, true),
                       to_west = fields(ix - 1, iy, true), to_north = fields(ix, iy + 1, true),
                       to_south = fields(ix, iy - 1, true);
    const double half_dx = 0.5 / grid.dx, half_dy = 0.5 / grid.dy;
    const double cap = share * narrowest_square() / dt, mixed_cap = share * std::sqrt(narrowest_square()) * dz / dt;
    const auto most_mixed = [&](double density, double bulk, double shear) {
        const double most = cap * density;
        return bulk + (4.0 / 3.0) * shear <= most ? most : smaller(most, mixed_cap * density);
    };
    Scratch& s = scratch_[thread()];
    const Carried face = s.face.arrays();
    double* __restrict divergence = s.divergence;
    double* __restrict slope_x = s.slope_x;
    double* __restrict slope_y = s.slope_y;
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
    if (fluid_.setup.boundaries.lower.end == End::periodic) {
        stress_between(nz - 1, 0);
        for (double* row : {face.normal, face.lateral, face.vertical, face.energy}) row[nz] = row[0];
    } else {  // no shear and no work, the normal stress of the cell beside the end if the end bears one
        for (const std::int64_t f : {std::int64_t{0}, nz}) {
            const std::int64_t cell = f == 0 ? 0 : nz - 1;
            const End end = f == 0 ? fluid_.setup.boundaries.lower.end : fluid_.setup.boundaries.upper.end;
            const double speed = here.thermal_speed[cell];
            const double bulk = speed * here.bulk[cell], shear = speed * here.shear[cell];
            const double most = most_mixed(here.density[cell], bulk, shear);
            const double coefficient = smaller(bulk, most) - (2.0 / 3.0) * smaller(shear, most);
            face.normal[f] = face.lateral[f] = face.energy[f] = 0.0;
            face.vertical[f] = end == End::stress_free ? 0.0 : coefficient * divergence[cell];
        }
        Ledger& books = fluid_.books_of(column);
        books.plate_impulse -= dt * face.vertical[0];
        books.lid_impulse -= dt * face.vertical[nz];
    }
}

void RelaxHorizontal::sum_stresses(std::int64_t column) {
    const Grid& grid = fluid_.grid();
    const std::int64_t nz = grid.nz, first = grid.first(column);
    const double per_dx = 1.0 / grid.dx, per_dy = 1.0 / grid.dy, per_dz = 1.0 / grid.dz;
    Scratch& s = scratch_[thread()];
    const Carried west = s.west.arrays(), east = s.east.arrays(), south = s.south.arrays(), north = s.north.arrays(),
                  face = s.face.arrays();
    double* __restrict momentum_x = fluid_.rates.momentum_x.data() + first;
    double* __restrict momentum_y = fluid_.rates.momentum_y.data() + first;
    double* __restrict momentum_z = fluid_.rates.momentum_z.data() + first;
    double* __restrict energy = fluid_.rates.energy.data() + first;
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

void RelaxHorizontal::apply(std::int64_t column, double dt) {
    const std::int64_t nz = fluid_.grid().nz, first = fluid_.grid().first(column);
    const double floor = fluid_.constants.floor_temperature;
    Flow& flow = fluid_.flow();
    const Fluid::Rates& rates = fluid_.rates;
    const double* density = flow.density.data() + first;
    double *__restrict u_x = flow.velocity_x.data() + first, *__restrict u_y = flow.velocity_y.data() + first,
                       *__restrict u_z = flow.velocity_z.data() + first,
                       *__restrict temperature = flow.temperature.data() + first;
    const double *momentum_x = rates.momentum_x.data() + first, *momentum_y = rates.momentum_y.data() + first,
                 *momentum_z = rates.momentum_z.data() + first, *energy = rates.energy.data() + first;
    double* __restrict corrected = scratch_[thread()].corrected;
    double* __restrict floored = scratch_[thread()].floored;
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
    Ledger& books = fluid_.books_of(column);
    books.dual_energy_gain += 1.5 * fluid_.grid().dz * sum_in_lanes(corrected, nz);
    books.floor_gain += 1.5 * fluid_.grid().dz * sum_in_lanes(floored, nz);
}

}  // namespace shaken::continuum
