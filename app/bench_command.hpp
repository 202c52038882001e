// SPDX-License-Identifier: MIT
// `shaken bench md` and `shaken bench continuum`: how fast the engines are on this machine, as one line of JSON.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace shaken::app {

struct MdBench {
    std::filesystem::path scene_file;  // empty: a uniform elastic gas
    std::vector<std::string> overrides;
    std::int64_t particles = 4000;
    double volume_fraction = 0.49;
    std::int64_t collisions = 2'000'000;
    std::int64_t cycles = 10, settle = 10;
    std::uint64_t seed = 1;
};

struct ContinuumBench {
    std::int64_t dimension = 1;
    std::string cells = "400";  // "21x21x400", "84x400" or "400": x, y, z; the last is z
    std::int64_t steps = 1000;
    std::string scheme = "muscl";
};

int run_md_bench(const MdBench& bench);
/// Throws UsageError for cells that do not fit the dimension.
int run_continuum_bench(const ContinuumBench& bench);

}  // namespace shaken::app
