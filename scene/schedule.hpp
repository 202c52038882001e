// SPDX-License-Identifier: MIT
// When a run is sampled, and what is kept of which instant: the one owner of sample instants, phases, averaged cycles,
// frames and maps. A layer is sampled at `phases` equal phases of every cycle, from the first to the end of the last; a
// uniform gas, whose cycle is one interval, at the start and at the end of each.
#pragma once

#include <cstdint>

#include "scene/scene.hpp"

namespace shaken::scene {

/// A sample instant: its cycle, and which of the cycle's sample instants it is. Its phase is ft = phase_index/phases.
struct Instant {
    std::int64_t cycle = 0, phase_index = 0;
    bool operator==(const Instant&) const = default;
};

class Schedule {
  public:
    explicit Schedule(const Scene& scene);

    std::int64_t phases() const { return phases_; }  // sample instants a cycle
    std::int64_t cycles() const { return settle_ + average_; }
    std::int64_t averaged() const { return average_; }  // cycles, the last ones
    std::int64_t samples() const { return cycles() * phases_ + (samples_its_end_ ? 1 : 0); }
    /// Samples before the first one averaged over.
    std::int64_t settling_samples() const { return settle_ * phases_; }

    /// The instant of a sample by its number since the start of cycle 0, and the other way round.
    Instant instant(std::int64_t sample) const { return {sample / phases_, sample % phases_}; }
    std::int64_t sample(const Instant& at) const { return at.cycle * phases_ + at.phase_index; }

    /// ft in [0, 1).
    double phase(const Instant& at) const {
        return static_cast<double>(at.phase_index) / static_cast<double>(phases_);
    }
    /// In sqrt(sigma/g).
    double time_in_cycle(const Instant& at) const { return phase(at) * period_; }
    double time(const Instant& at) const { return static_cast<double>(at.cycle) * period_ + time_in_cycle(at); }

    bool is_averaged(std::int64_t cycle) const { return cycle >= settle_ && cycle < cycles(); }
    /// The how many-th averaged cycle this is, from 0 on.
    std::int64_t averaged_cycle(std::int64_t cycle) const { return cycle - settle_; }

    /// Whether the whole state is kept: of a layer at `frames` equal phases of the last frame_cycles; of a gas at the
    /// ends of `frames` equal parts of the averaging time.
    bool is_frame(const Instant& at) const;
    /// Whether a map of z_cm(x, y) is kept: at `maps` equal phases of every cycle.
    bool is_map(const Instant& at) const { return keeps_maps_ && at.phase_index % (phases_ / maps_) == 0; }

  private:
    std::int64_t phases_, settle_, average_, frames_, frame_cycles_, maps_;
    bool keeps_maps_, samples_its_end_;
    double period_;  // of the plate; of a gas its sampling interval
};

/// The sample instant of cycle 0 that a layer starts at: initial.phase of its file, 0 without one. Throws SceneError
/// where that is no sample instant, or where the first cycle, then short, would be the only one.
Instant start_of(const Scene& scene);

}  // namespace shaken::scene
