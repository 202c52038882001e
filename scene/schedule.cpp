// SPDX-License-Identifier: MIT
#include "scene/schedule.hpp"

#include <fmt/format.h>

#include <cmath>

#include "scene/errors.hpp"

namespace shaken::scene {

Schedule::Schedule(const Scene& scene)
    : phases_(scene.sample.phases),
      settle_(scene.sample.settle),
      average_(scene.sample.average),
      frames_(scene.sample.frames),
      frame_cycles_(scene.sample.frame_cycles),
      maps_(scene.sample.maps),
      keeps_maps_(scene.sample.map_bin > 0.0),
      samples_its_end_(scene.kind == Kind::uniform),
      period_(scene.motion.period()) {
    if (scene.kind != Kind::uniform) return;
    frames_ = scene.uniform.frames;
    period_ = scene.uniform.interval;  // 1/(1/interval) may differ in its last bit
}

bool Schedule::is_frame(const Instant& at) const {
    if (samples_its_end_) {
        const std::int64_t since = at.cycle - settle_;
        return since > 0 && since * frames_ / average_ > (since - 1) * frames_ / average_;
    }
    return frames_ > 0 && at.cycle >= cycles() - frame_cycles_ && at.phase_index % (phases_ / frames_) == 0;
}

Instant start_of(const Scene& scene) {
    if (scene.kind != Kind::layer || scene.initial.file.empty()) return {};
    const double phases = static_cast<double>(scene.sample.phases), instant = scene.initial.phase * phases;
    constexpr double round_off = 1e-9;
    if (std::abs(instant - std::round(instant)) > round_off * phases)
        throw SceneError({}, fmt::format("initial.phase = {} is no sample instant of sample.phases = {}",
                                         scene.initial.phase, scene.sample.phases));
    const Instant start{0, std::llround(instant) % scene.sample.phases};
    if (start.phase_index > 0 && Schedule(scene).cycles() < 2)
        throw SceneError({}, "initial.phase above 0 needs two cycles, settling or averaged: the first is short");
    return start;
}

}  // namespace shaken::scene
