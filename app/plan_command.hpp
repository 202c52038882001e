// SPDX-License-Identifier: MIT
// `shaken plan SCENE --error 1%` or `--seconds 60`: proposes a scene for a wished error or time, and writes it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace shaken::app {

struct PlanOptions {
    std::filesystem::path scene_file;
    std::vector<std::string> overrides;
    std::optional<std::string> error;  // "1%" or "0.01"
    std::optional<double> seconds;
    std::filesystem::path out;  // empty: NAME.plan.toml in the current folder, NAME that of the scene file
    bool overwrite = false;
    bool json = false;
};

int run_plan(const PlanOptions& options);

}  // namespace shaken::app
