// SPDX-License-Identifier: MIT
// Bins what the continuum engine holds at the sample instants, by the rule that bins the particles: every cell is a
// slab of gas that fills the bins it overlaps.
#pragma once

#include <cstdint>

#include "continuum/solver.hpp"
#include "fields/phase_moments.hpp"
#include "files/checkpoint.hpp"
#include "scene/scene.hpp"

namespace compare {

class ContinuumSampler {
  public:
    /// floor_height: height of the continuum's floor above the plate, 0 or half a diameter; where it lies is a choice
    /// of the model, and the equations do not know it.
    explicit ContinuumSampler(const scene::Scene& scene, double floor_height = 0.0);

    /// Cycles before the scene's settling time and after its averaging time are left out.
    void sample(const continuum::Solver& solver, std::int64_t cycle, std::int64_t phase);
    void save(files::CheckpointWriter& out) const;
    void restore(const files::CheckpointReader& in);

    const fields::PhaseMoments& moments() const { return moments_; }

  private:
    scene::PlateMotion motion_;
    std::int64_t settle_, average_;
    double floor_height_;
    fields::PhaseMoments moments_;
};

}  // namespace compare
