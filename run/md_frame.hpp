// SPDX-License-Identifier: MIT
// A whole state of grains as a record of a stream, and back.
#pragma once

#include <span>
#include <vector>

#include "md/snapshot.hpp"

namespace shaken::run {

/// cycle, time in it, number of particles; then positions, velocities and, where there are any, spins (N, 3).
std::vector<double> packed(const md::Snapshot& frame);
/// Throws files::Damaged.
md::Snapshot unpacked(std::span<const double> record);

}  // namespace shaken::run
