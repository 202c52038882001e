// SPDX-License-Identifier: MIT
// Whoever measures a run. Measuring is not simulating: an observer sees snapshots and cannot change the trajectory;
// its sums go into the same checkpoint as the engine's state.
#pragma once

#include <cstdint>

#include "files/checkpoint.hpp"
#include "md/snapshot.hpp"

namespace shaken::md {

class Observer {
  public:
    virtual ~Observer() = default;
    /// One sample instant; phase is the index in [0, phases) of the scene's sampling.
    virtual void sample(const Snapshot& snapshot, std::int64_t cycle, std::int64_t phase) = 0;
    virtual void save(files::CheckpointWriter& out) const = 0;
    virtual void restore(const files::CheckpointReader& in) = 0;
};

}  // namespace shaken::md
