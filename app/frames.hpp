// SPDX-License-Identifier: MIT
// Which sample instants are kept as whole frames: equal phases of the last cycle or cycles, for pictures and other
// programs.
#pragma once

#include <cstdint>

#include "scene/scene.hpp"

namespace shaken::app {

/// A sample instant by its number since the start.
struct Instant {
    std::int64_t cycle, phase;
    double ft(const scene::Scene& scene) const {
        return static_cast<double>(phase) / static_cast<double>(scene.sample.phases);
    }
    double time_in_cycle(const scene::Scene& scene) const { return ft(scene) * scene.motion.period(); }
    double time(const scene::Scene& scene) const {
        return static_cast<double>(cycle) * scene.motion.period() + time_in_cycle(scene);
    }
};

inline Instant instant_of(std::int64_t sample, const scene::Scene& scene) {
    return {sample / scene.sample.phases, sample % scene.sample.phases};
}

inline bool is_frame(const Instant& instant, const scene::Scene& scene) {
    return scene.sample.frames > 0 &&
           instant.cycle >= scene.sample.settle + scene.sample.average - scene.sample.frame_cycles &&
           instant.phase % (scene.sample.phases / scene.sample.frames) == 0;
}

}  // namespace shaken::app
