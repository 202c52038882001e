// SPDX-License-Identifier: MIT
#include "md/benchmark.hpp"

#include <chrono>

namespace shaken::md {

namespace {

template <class Work>
BenchmarkResult timed(Simulation& simulation, Work work) {
    using Clock = std::chrono::steady_clock;
    const std::int64_t before = simulation.counters().pair_collisions;
    const Clock::time_point start = Clock::now();
    work();
    const std::chrono::duration<double> wall = Clock::now() - start;
    return {simulation.particles(), simulation.counters().pair_collisions - before, wall.count(),
            static_cast<double>(simulation.memory()) / static_cast<double>(simulation.particles())};
}

}  // namespace

BenchmarkResult benchmark(const UniformSystem& system, std::int64_t collisions, const Options& options) {
    Simulation simulation(system, options);
    simulation.advance_collisions(collisions / 5);
    return timed(simulation, [&] { simulation.advance_collisions(collisions); });
}

BenchmarkResult benchmark(const scene::Scene& scene, std::int64_t settle, std::int64_t cycles, const Options& options) {
    Simulation simulation(scene, options);
    simulation.advance_to(settle, 0.0);
    return timed(simulation, [&] { simulation.advance_to(settle + cycles, 0.0); });
}

}  // namespace shaken::md
