// SPDX-License-Identifier: MIT
// `shaken patterns DIR`: the horizontal structure of what either engine left in a folder, in numbers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace shaken::app {

struct PatternsOptions {
    std::filesystem::path folder;
    double phase = 0.25;
    std::optional<std::int64_t> first;   // cycle; without: the scene's settling time
    std::optional<std::int64_t> cycles;  // without: all that follow
    std::size_t waves = 5;               // how many, the strongest
    bool json = false;
};

/// Prints a table (or one line of JSON) and writes patterns.json. Returns an exit code; throws files::NoInput where no
/// run with maps is there, UsageError where the window holds none.
int run_patterns(const PatternsOptions& options);

}  // namespace shaken::app
