// SPDX-License-Identifier: MIT
// Whoever measures a run. Measuring is not simulating: an observer sees snapshots and cannot change the trajectory;
// its sums go into the same checkpoint as the engine's state.
#pragma once

#include "files/checkpoint.hpp"
#include "md/snapshot.hpp"
#include "scene/schedule.hpp"

namespace shaken::md {

class Observer {
  public:
    virtual ~Observer() = default;
    virtual void sample(const Snapshot& snapshot, const scene::Instant& at) = 0;
    virtual void save(files::CheckpointWriter& out) const = 0;
    virtual void restore(const files::CheckpointReader& in) = 0;
};

}  // namespace shaken::md
