// SPDX-License-Identifier: MIT
// Bins what the MD engine shows at the sample instants: moments of the particles by phase and height above the plate,
// and the height of the centre of mass of all of them.
#pragma once

#include <cstdint>

#include "fields/phase_moments.hpp"
#include "files/checkpoint.hpp"
#include "md/observer.hpp"
#include "scene/scene.hpp"

namespace shaken::compare {

/// The bins of a scene, the same for both engines: from the plate to the continuum's lid, [sample] bin wide.
/// Particles above the lid count in the centre of mass only.
fields::Bins scene_bins(const scene::Scene& scene);

/// Empty sums for a scene: its phases, bins, area, cycles averaged over, in at most ten blocks.
fields::PhaseMoments scene_moments(const scene::Scene& scene);

class MdSampler : public md::Observer {
  public:
    explicit MdSampler(const scene::Scene& scene);

    /// Cycles before the scene's settling time and after its averaging time are left out.
    void sample(const md::Snapshot& snapshot, std::int64_t cycle, std::int64_t phase) override;
    void save(files::CheckpointWriter& out) const override;
    void restore(const files::CheckpointReader& in) override;

    const fields::PhaseMoments& moments() const { return moments_; }

  private:
    scene::PlateMotion motion_;
    std::int64_t settle_, average_;
    fields::PhaseMoments moments_;
};

}  // namespace shaken::compare
