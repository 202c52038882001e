// SPDX-License-Identifier: MIT
// Bins what the MD engine shows at the sample instants: moments of the particles by phase and height above the plate,
// and the height of the centre of mass of all of them.
#pragma once

#include "fields/height_maps.hpp"
#include "fields/phase_moments.hpp"
#include "files/checkpoint.hpp"
#include "md/observer.hpp"
#include "scene/scene.hpp"
#include "scene/schedule.hpp"

namespace shaken::compare {

/// The bins of a scene, the same for both engines: from the plate to the continuum's lid, [sample] bin wide.
/// Particles above the lid count in the centre of mass only.
fields::Bins scene_bins(const scene::Scene& scene);

/// Empty sums of an engine for a scene: its phases, bins, area, cycles averaged over, in at most ten blocks.
fields::PhaseMoments scene_moments(const scene::Scene& scene, fields::Deposits deposits, fields::Heights heights);

/// The horizontal bins of a scene's maps, as wide as [sample] map_bin as nearly as whole bins can be; none without it.
fields::HorizontalGrid scene_map_grid(const scene::Scene& scene);

class MdSampler : public md::Observer {
  public:
    explicit MdSampler(const scene::Scene& scene, fields::Heights heights = fields::Heights::kept);

    /// Cycles before the scene's settling time and after its averaging time are left out.
    void sample(const md::Snapshot& snapshot, const scene::Instant& at) override;
    void save(files::CheckpointWriter& out) const override;
    void restore(const files::CheckpointReader& in) override;

    const fields::PhaseMoments& moments() const { return moments_; }
    /// Of every cycle from the start; empty unless the scene asks for maps.
    const fields::HeightMaps& maps() const { return maps_; }
    /// For whoever has taken them elsewhere.
    void clear_maps() { maps_.clear(); }

  private:
    scene::PlateMotion motion_;
    scene::Schedule schedule_;
    fields::PhaseMoments moments_;
    fields::HeightMaps maps_;
};

}  // namespace shaken::compare
