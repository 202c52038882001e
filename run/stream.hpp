// SPDX-License-Identifier: MIT
// What a run lets go of at each sample instant, so that its memory does not grow with its cycles: rows of the recorded
// columns, heights of the centre of mass, maps, whole states. The driver keeps them in ENGINE.stream.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

namespace shaken::run {

/// row: sample, time, a value for each column. height: averaged cycle, phase_index, z_cm in the lab. map: cycle, phase,
/// heights (ny, nx). frame: as its record packs it.
enum class Stream : std::uint64_t { row = 1, height = 2, map = 3, frame = 4 };

using Emit = std::function<void(Stream, std::span<const double>)>;

/// Whether the user wants the run to end: a signal, or the limit of time.
using AskedToStop = std::function<bool()>;

/// Wall and CPU seconds spent on a run, over all its restarts.
struct Spent {
    double wall = 0.0, cpu = 0.0;
};

}  // namespace shaken::run
