// SPDX-License-Identifier: MIT
#include "compare/continuum_sampler.hpp"

#include <cstddef>

#include "compare/md_sampler.hpp"

namespace compare {

ContinuumSampler::ContinuumSampler(const scene::Scene& scene, double floor_height)
    : motion_(scene.motion),
      settle_(scene.sample.settle),
      average_(scene.sample.average),
      floor_height_(floor_height),
      moments_(scene_moments(scene)) {}

void ContinuumSampler::sample(const continuum::Solver& solver, std::int64_t cycle, std::int64_t phase) {
    if (cycle < settle_ || cycle >= settle_ + average_) return;
    moments_.begin_sample(cycle - settle_, phase);
    const double time = static_cast<double>(phase) / static_cast<double>(moments_.phases()) * motion_.period();
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
                moments_.add_slab(lower, lower + dz, column.density[k],
                                  {column.velocity_x[k], column.velocity_y[k], column.velocity_z[k] + plate_velocity},
                                  column.temperature[k], area_share);
                mass += column.density[k];
                moment += column.density[k] * (lower + 0.5 * dz);
            }
        }
    }
    moments_.set_centre_of_mass(plate + moment / mass);
}

void ContinuumSampler::save(files::CheckpointWriter& out) const { moments_.save(out, "compare/continuum/"); }

void ContinuumSampler::restore(const files::CheckpointReader& in) { moments_.restore(in, "compare/continuum/"); }

}  // namespace compare
