// SPDX-License-Identifier: MIT
#include "app/bench_command.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/exit_codes.hpp"
#include "app/options.hpp"
#include "continuum/benchmark.hpp"
#include "md/benchmark.hpp"
#include "run/engines.hpp"
#include "compare/scenes.hpp"
#include "scene/read_scene.hpp"

namespace shaken::app {

namespace {

/// "21x21x400" as counts in x, y, z; axes left out have one cell.
std::array<std::int64_t, 3> cells_of(const std::string& text, std::int64_t dimension) {
    std::vector<std::int64_t> counts;
    const char* at = text.data();
    const char* const end = at + text.size();
    for (;;) {
        std::int64_t count = 0;
        const auto [next, error] = std::from_chars(at, end, count);
        if (error != std::errc{} || count < 1) break;
        counts.push_back(count);
        if (next == end) break;
        if (*next != 'x') break;
        at = next + 1;
    }
    const std::string wanted = dimension == 1 ? "NZ" : dimension == 2 ? "NXxNZ" : "NXxNYxNZ";
    if (dimension < 1 || dimension > 3 || static_cast<std::int64_t>(counts.size()) != dimension) {
        throw UsageError(fmt::format("--cells {} does not fit --dimension {}: give {}", text, dimension, wanted));
    }
    if (dimension == 1) return {1, 1, counts[0]};
    if (dimension == 2) return {counts[0], 1, counts[1]};
    return {counts[0], counts[1], counts[2]};
}

}  // namespace

int run_md_bench(const MdBench& bench) {
    md::BenchmarkResult result;
    if (bench.scene_file.empty()) {
        md::UniformSystem system;
        system.particles = bench.particles;
        system.volume_fraction = bench.volume_fraction;
        system.seed = bench.seed;
        result = md::benchmark(system, bench.collisions);
    } else {
        const scene::Scene scene = compare::read_scene(bench.scene_file, bench.overrides);
        result = md::benchmark(scene, bench.settle, bench.cycles, run::md_options_of(scene));
    }
    const nlohmann::ordered_json line{{"particles", result.particles},
                                      {"collisions", result.collisions},
                                      {"seconds", result.seconds},
                                      {"collisions_per_second", result.collisions_per_second()},
                                      {"bytes_per_particle", result.bytes_per_particle}};
    fmt::print("{}\n", line.dump());
    return exit_code::done;
}

int run_continuum_bench(const ContinuumBench& bench) {
    const auto [nx, ny, nz] = cells_of(bench.cells, bench.dimension);
    if (nz < 16) throw UsageError(fmt::format("--cells {}: at least 16 cells in z are needed", bench.cells));
    const continuum::BenchmarkResult result = continuum::benchmark(nx, ny, nz, bench.steps, bench.scheme);
    const nlohmann::ordered_json line{
        {"scheme", result.scheme},
        {"cells", result.cells},
        {"steps", result.steps},
        {"threads", result.threads},
        {"seconds", result.wall_seconds},
        {"cell_updates_per_second", result.cell_updates_per_second},
        {"cell_updates_per_second_per_core", result.cell_updates_per_second / result.threads},
        {"bytes_per_cell", result.bytes_per_cell}};
    fmt::print("{}\n", line.dump());
    return exit_code::done;
}

}  // namespace shaken::app
