// SPDX-License-Identifier: MIT
// Standard errors by leaving one block of cycles out (Tukey 1958): for B blocks and estimates x_b without block b,
// s^2 = (B-1)/B sum_b (x_b - <x_b>)^2. Exact for a mean, right to first order for a smooth function of means; for a
// phase, which moves in steps, it says only whether the step was ever taken. Blocks must be longer than the memory of
// the run from cycle to cycle.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

namespace shaken::compare {

/// NaN for fewer than two blocks, or where an estimate is not finite.
inline double jackknife_error(std::span<const double> without_each_block) {
    const auto blocks = static_cast<double>(without_each_block.size());
    if (without_each_block.size() < 2) return std::nan("");
    double mean = 0.0;
    for (const double x : without_each_block) mean += x / blocks;
    double squares = 0.0;
    for (const double x : without_each_block) squares += (x - mean) * (x - mean);
    return std::sqrt((blocks - 1.0) / blocks * squares);
}

}  // namespace shaken::compare
