// SPDX-License-Identifier: MIT
// `shaken fit-noise TABLE`: the noise strength and mean-field onset of a measured onset, by the noisy Swift-Hohenberg
// model.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace shaken::app {

struct FitNoiseOptions {
    std::filesystem::path
        table;  // CSV with columns value, mean_square, order and, if there, their _error; or its folder
    std::vector<double> noises{3e-4, 1e-3, 3e-3, 6e-3, 1e-2, 1.5e-2, 2.2e-2, 4e-2};
    double lowest = -0.2, highest = 0.2;  // controls of the model
    std::int64_t controls = 17;
    std::int64_t settle = 8000, average = 2000;  // steps
    std::int64_t seeds = 1;
    std::uint64_t seed = 1;
    std::filesystem::path model;  // CSV of the model's curves: read if there, else written; default beside the table
    int draws = 200;              // of the bootstrap
    bool onset_by_size = false;   // the onset is where <psi^2> rises most steeply, not P_max
};

/// Prints one line of JSON, with the fits without each of the values in turn. Errors by bootstrap over the blocks of
/// TABLE.blocks.csv (columns value, run, mean_square, power_0 to power_20), or within the table's errors where there
/// are none. The model's curves go to options.model. Returns an exit code; throws files::NoInput, files::Damaged (not
/// such a table) or UsageError.
int run_fit_noise(const FitNoiseOptions& options);

}  // namespace shaken::app
