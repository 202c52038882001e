// SPDX-License-Identifier: MIT
// How fast the engine runs: pair collisions a second of the event loop alone, set-up and equilibration left out.
#pragma once

#include <cstdint>

#include "md/simulation.hpp"

namespace shaken::md {

struct BenchmarkResult {
    std::int64_t particles = 0;
    std::int64_t collisions = 0;  // pair collisions counted
    double seconds = 0.0;         // wall time of the loop alone
    double bytes_per_particle = 0.0;
    double collisions_per_second() const { return static_cast<double>(collisions) / seconds; }
};

/// Uniform system: a fifth of the collisions to equilibrate, then `collisions` timed.
BenchmarkResult benchmark(const UniformSystem& system, std::int64_t collisions, const Options& options = {});
/// Shaken layer: `settle` cycles, then `cycles` timed.
BenchmarkResult benchmark(const scene::Scene& scene, std::int64_t settle, std::int64_t cycles,
                          const Options& options = {});

}  // namespace shaken::md
