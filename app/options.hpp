// SPDX-License-Identifier: MIT
// What the subcommands that run an engine are told on the command line.
#pragma once

#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace shaken::app {

/// A command line that cannot be meant; exit code 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct EngineOptions {
    std::filesystem::path scene_file;
    std::vector<std::string> overrides;  // --set section.key=value
    std::filesystem::path out;
    std::filesystem::path resume;  // folder of a run to go on with, in place of scene_file and out
    bool overwrite = false;
    bool as_child = false;  // of `run`, which has prepared the folder and speaks to the user
    bool quiet = false;
    double max_walltime = std::numeric_limits<double>::infinity();  // seconds
    double checkpoint_every = 300.0;                                // seconds of wall time
};

}  // namespace shaken::app
