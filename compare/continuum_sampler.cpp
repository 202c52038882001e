// SPDX-License-Identifier: MIT
#include "compare/continuum_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "compare/md_sampler.hpp"

namespace shaken::compare {

namespace {

/// Slope of a field in a cell, per cell: central, limited so that no value in the cell leaves the range of its
/// neighbours (monotonised central, van Leer 1977). One-sided differences are zero at the ends of the column.
double limited_slope(std::span<const double> values, std::size_t k) {
    if (k == 0 || k + 1 == values.size()) return 0.0;
    const double below = values[k] - values[k - 1], above = values[k + 1] - values[k];
    if (below * above <= 0.0) return 0.0;
    const double size = std::min({0.5 * std::abs(below + above), 2.0 * std::abs(below), 2.0 * std::abs(above)});
    return std::copysign(size, below);
}

}  // namespace

ContinuumSampler::ContinuumSampler(const scene::Scene& scene, double floor_height, fields::Heights heights)
    : motion_(scene.motion),
      schedule_(scene),
      floor_height_(floor_height),
      moments_(scene_moments(scene, fields::Deposits::cells, heights)),
      maps_(scene_map_grid(scene)) {}

void ContinuumSampler::keep_map(const continuum::Solver& solver, const scene::Instant& at) {
    const double floor = motion_.position(schedule_.time_in_cycle(at)) + floor_height_;
    const double side_x = maps_.grid().length_x / static_cast<double>(solver.cells_x());
    const double side_y = maps_.grid().length_y / static_cast<double>(solver.cells_y());
    maps_.begin(at.cycle, schedule_.phase(at));
    for (std::int64_t iy = 0; iy < solver.cells_y(); ++iy) {
        for (std::int64_t ix = 0; ix < solver.cells_x(); ++ix) {
            const continuum::ColumnView column = solver.column(ix, iy);
            double mass = 0.0, moment = 0.0;
            for (std::size_t k = 0; k < column.density.size(); ++k) {
                mass += column.density[k];
                moment += column.density[k] * (static_cast<double>(k) + 0.5) * solver.spacing_z();
            }
            maps_.add_rectangle(side_x * static_cast<double>(ix), side_y * static_cast<double>(iy), side_x, side_y,
                                mass, floor + moment / mass);
        }
    }
    maps_.end();
}

void ContinuumSampler::sample(const continuum::Solver& solver, const scene::Instant& at) {
    if (schedule_.is_map(at)) keep_map(solver, at);
    if (!schedule_.is_averaged(at.cycle)) return;
    moments_.begin_sample(schedule_.averaged_cycle(at.cycle), at.phase_index);
    const double time = schedule_.time_in_cycle(at);
    const double plate = motion_.position(time);
    const double plate_velocity = motion_.velocity(time);
    const double area_share = 1.0 / static_cast<double>(solver.cells_x() * solver.cells_y());
    const double dz = solver.spacing_z();
    double mass = 0.0, moment = 0.0;
    for (std::int64_t iy = 0; iy < solver.cells_y(); ++iy) {
        for (std::int64_t ix = 0; ix < solver.cells_x(); ++ix) {
            const continuum::ColumnView column = solver.column(ix, iy);
            for (std::size_t k = 0; k < column.density.size(); ++k) {
                const double lower = floor_height_ + dz * static_cast<double>(k);
                const double centre = lower + 0.5 * dz;
                mass += column.density[k];
                moment += column.density[k] * centre;
                add_cell(column, k, lower, dz, plate_velocity, area_share);
            }
        }
    }
    moments_.set_centre_of_mass(plate + moment / mass);
}

void ContinuumSampler::add_cell(const continuum::ColumnView& column, std::size_t k, double lower, double dz,
                                double plate_velocity, double area_share) {
    const double centre = lower + 0.5 * dz;
    const auto at = [&](std::span<const double> values, double height) {
        return values[k] + limited_slope(values, k) * (height - centre) / dz;
    };
    const fields::Bins& bins = moments_.bins();
    double from = lower;
    for (std::int64_t bin = bins.index(lower); from < lower + dz; ++bin) {
        const double to = std::min(lower + dz, bins.edge(bin + 1));
        if (to <= from) continue;
        const double middle = 0.5 * (from + to);
        moments_.add_slab(from, to, at(column.density, middle),
                          {at(column.velocity_x, middle), at(column.velocity_y, middle),
                           at(column.velocity_z, middle) + plate_velocity},
                          at(column.temperature, middle), area_share);
        from = to;
    }
}

void ContinuumSampler::save(files::CheckpointWriter& out) const {
    moments_.save(out, "compare/continuum/");
    maps_.save(out, "compare/continuum/maps/");
}

void ContinuumSampler::restore(const files::CheckpointReader& in) {
    moments_.restore(in, "compare/continuum/");
    maps_.restore(in, "compare/continuum/maps/");
}

}  // namespace shaken::compare
