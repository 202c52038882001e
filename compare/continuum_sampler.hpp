// SPDX-License-Identifier: MIT
// Bins what the continuum engine holds at the sample instants, by the rule that bins the particles. A cell that lies
// across the edge of a bin is parted there, its fields taken linear within it: with constant ones the middles of bins
// would shift to and fro with the ratio of bin to cell, and so would the slopes of the profile. Mass is kept exactly.
#pragma once

#include <cstddef>

#include "continuum/solver.hpp"
#include "fields/height_maps.hpp"
#include "fields/phase_moments.hpp"
#include "files/checkpoint.hpp"
#include "scene/scene.hpp"
#include "scene/schedule.hpp"

namespace shaken::compare {

class ContinuumSampler {
  public:
    /// floor_height: height of the continuum's floor above the plate, 0 or half a diameter; where it lies is a choice
    /// of the model, and the equations do not know it.
    explicit ContinuumSampler(const scene::Scene& scene, double floor_height = 0.0,
                              fields::Heights heights = fields::Heights::kept);

    /// Cycles before the scene's settling time and after its averaging time are left out.
    void sample(const continuum::Solver& solver, const scene::Instant& at);
    void save(files::CheckpointWriter& out) const;
    void restore(const files::CheckpointReader& in);

    const fields::PhaseMoments& moments() const { return moments_; }
    /// Of every cycle from the start; empty unless the scene asks for maps.
    const fields::HeightMaps& maps() const { return maps_; }
    /// For whoever has taken them elsewhere.
    void clear_maps() { maps_.clear(); }

  private:
    void keep_map(const continuum::Solver& solver, const scene::Instant& at);
    void add_cell(const continuum::ColumnView& column, std::size_t k, double lower, double dz, double plate_velocity,
                  double area_share);

    scene::PlateMotion motion_;
    scene::Schedule schedule_;
    double floor_height_;
    fields::PhaseMoments moments_;
    fields::HeightMaps maps_;
};

}  // namespace shaken::compare
