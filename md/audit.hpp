// SPDX-License-Identifier: MIT
// An independent look at a snapshot: does any particle overlap another or a wall? Uses nothing of the engine.
#pragma once

#include <cstdint>
#include <optional>

#include "md/snapshot.hpp"
#include "scene/plate_motion.hpp"

namespace shaken::md {

struct Box {
    double x = 0.0, y = 0.0, z = 0.0;
    bool periodic_z = false;                  // false: plate below, ceiling at z
    std::optional<scene::PlateMotion> plate;  // none in a box periodic in z
};

struct Audit {
    double largest_overlap = 0.0;                             // of a pair, sigma; 0 if none
    std::int64_t first = -1, second = -1;                     // that pair
    double deepest_in_plate = 0.0, deepest_in_ceiling = 0.0;  // sigma; 0 if none
};

/// All pairs through cells, O(N). Throws InvariantBroken if a coordinate is not finite.
Audit audit(const Snapshot& snapshot, const Box& box);

}  // namespace shaken::md
