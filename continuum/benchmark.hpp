// SPDX-License-Identifier: MIT
// How fast the solver is: a shaken layer of the given size, advanced a number of whole steps.
#pragma once

#include <cstdint>
#include <string>

namespace shaken::continuum {

struct BenchmarkResult {
    std::int64_t cells = 0;
    std::int64_t steps = 0;
    int threads = 1;
    double wall_seconds = 0.0;
    double cell_updates_per_second = 0.0;  // whole steps, all stages, all threads
    double bytes_per_cell = 0.0;
    std::string scheme;
};

/// Runs `steps` steps of a layer as deep as chapter 5's on cells_x x cells_y x cells_z cells (dx = dy = 2, dz = 0.2).
/// Throws std::invalid_argument for sizes below 1 (below 16 in z).
BenchmarkResult benchmark(std::int64_t cells_x, std::int64_t cells_y, std::int64_t cells_z, std::int64_t steps,
                          const std::string& scheme = "muscl");

}  // namespace shaken::continuum
