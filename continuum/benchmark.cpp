// SPDX-License-Identifier: MIT
#include "continuum/benchmark.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "continuum/ftcs/ftcs.hpp"
#include "continuum/initial_state.hpp"
#include "continuum/step/evolution.hpp"
#include "scene/errors.hpp"

namespace shaken::continuum {

BenchmarkResult benchmark(std::int64_t cells_x, std::int64_t cells_y, std::int64_t cells_z, std::int64_t steps,
                          const std::string& scheme) {
    if (cells_x < 1 || cells_y < 1 || cells_z < 16 || steps < 1)
        throw std::invalid_argument(
            fmt::format("continuum benchmark: {} x {} x {} cells, {} steps: at least 1 x 1 x 16 and 1", cells_x,
                        cells_y, cells_z, steps));
    if (scheme == Ftcs::name)
        throw scene::SceneError({}, "bench continuum: \"ftcs\" has no fluxes to time; known: muscl, weno5");
    scene::Scene scene;
    scene.box.x = 2.0 * static_cast<double>(cells_x);
    scene.box.y = 2.0 * static_cast<double>(cells_y);
    scene.number_of_particles = std::llround(6.0 * scene.box.x * scene.box.y);
    scene.depth = 5.4;
    scene.motion = scene::PlateMotion::from_acceleration(2.2, 0.4174 / std::sqrt(5.4));
    scene.particles.restitution = scene::RestitutionVelocity{0.7, 1.0};
    scene.initial.noise = cells_x * cells_y > 1 ? 0.02 : 0.0;
    scene.continuum.spacing = 0.2;
    scene.continuum.lid = 0.2 * static_cast<double>(cells_z);
    scene.continuum.scheme = {scheme, {}};
    scene.continuum.dimension = {cells_x == 1 && cells_y == 1 ? "1" : (cells_x == 1 || cells_y == 1 ? "2" : "3"), {}};

    Evolution evolution(make_setup(scene));
    const double period = scene.motion.period();
    double t = 0.0;
    const auto advance = [&](std::int64_t count) {
        for (std::int64_t k = 0; k < count; ++k) {
            const double dt = evolution.longest_step();
            evolution.step(t, dt);
            t = std::fmod(t + dt, period);
        }
    };
    advance(std::max<std::int64_t>(2, steps / 10));  // caches, threads and the layer itself get going
    const auto begin = std::chrono::steady_clock::now();
    advance(steps);
    BenchmarkResult result;
    result.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    result.cells = evolution.grid().cells();
    result.steps = steps;
    result.threads = static_cast<int>(std::min<std::int64_t>(omp_get_max_threads(), evolution.grid().columns()));
    result.cell_updates_per_second =
        static_cast<double>(result.cells * steps * Evolution::carries_a_step) / result.wall_seconds;
    result.bytes_per_cell = evolution.bytes_per_cell();
    result.scheme = scheme;
    return result;
}

}  // namespace shaken::continuum
