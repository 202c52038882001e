// SPDX-License-Identifier: MIT
// When a run is to be given up. Under constant restitution a small cluster can lose all its relative speed in ever more
// contacts within a finite time (inelastic collapse: McNamara and Young 1994). Such a cascade shows in the closing
// speeds: each decade of speed below the usual ones holds a tenth of the contacts of the decade above, where unrelated
// contacts would hold a hundredth. So contacts slower than any unrelated ones are counted. The round-off of a real
// cascade lets it go on for a while, at a million contacts a second and for no physics, until the clock stands still.
#pragma once

#include <cstdint>
#include <string>

#include "files/checkpoint.hpp"

namespace shaken::md {

class CollapseWatch {
  public:
    /// collapses: whether restitution stays below 1 as the closing speed goes to zero, without a remedy. If not, only a
    /// clock that stands still ends a run.
    CollapseWatch(bool collapses, double particles) : collapses_(collapses), particles_(particles) {}

    /// speed: what the slowest contacts are measured against; sqrt(g sigma), or the thermal speed of a gas.
    void begin_epoch(double speed) { state_.slow = collapses_ ? slowest_share * speed : 0.0; }
    /// The clock went back by this much.
    void rebase(double by) { state_.time -= by; }
    void start(double now) { state_.time = now; }

    /// Every contact of a pair, by their numbers; closing speed above 0.
    void pair(double closing_speed, std::uint32_t first, std::uint32_t second) {
        if (closing_speed < state_.slow) [[unlikely]] {
            ++state_.slow_contacts;
            state_.first = first;
            state_.second = second;
        }
    }
    bool due(std::int64_t contacts) const { return contacts - state_.contacts >= window; }

    /// What has been counted since the start.
    struct Totals {
        std::int64_t contacts = 0, pairs = 0;
        double virial = 0.0;
    };
    /// Looks at the contacts since the last look. Throws Stalled; `last` says who met last.
    void look(const Totals& now, std::int64_t cycle, double time, const std::string& last);

    void save(files::CheckpointWriter& out) const { out.put("md.collapse_watch", state_); }
    void restore(const files::CheckpointReader& in) { state_ = in.take_one<State>("md.collapse_watch"); }

    /// Contacts between looks.
    static constexpr std::int64_t window = 100000;
    /// Contacts that close slower than this share of the speed count as slow. Of unrelated ones, whose speeds are
    /// spread as v dv, one in 10^14 is.
    static constexpr double slowest_share = 1e-7;
    /// So many slow ones of a window are a collapse. Found by experiment (docs/validation.md).
    static constexpr std::int64_t most_slow = 5;
    /// A window shorter than this, with particles closer than stalled_path to each other all the while, is a clock that
    /// stands still: a million particles at contact rate 100 each need four orders of magnitude longer.
    static constexpr double stalled_time = 1e-7, stalled_path = 2e-6;

  private:
    struct State {
        std::int64_t contacts = 0, pairs = 0, slow_contacts = 0;
        double virial = 0.0, time = 0.0, slow = 0.0;
        std::uint32_t first = 0, second = 0;
    };
    State state_;
    bool collapses_;
    double particles_;
};

}  // namespace shaken::md
