// SPDX-License-Identifier: MIT
// What a homogeneous gas did, in blocks in which a particle was due for equally many collisions: the integral of
// sqrt(T) is shared out evenly. In a gas that cools the memory of the velocities lasts as many collisions late as
// early, so that such blocks are alike where blocks of equal time are not.
#pragma once

#include <vector>

#include "fields/time_series.hpp"

namespace shaken::run {

/// One entry a block, in the order of time.
struct GasBlocks {
    std::vector<double> compressibility;  // Z = p/(nT), over the block
    std::vector<double> rate;             // collisions of a particle over the integral of sqrt(T)
    std::vector<double> cumulant;         // a2, mean over the block's samples
    std::vector<double> cooling;          // growth of 1/sqrt(T) in a time of 1
};

/// From row `first` of a run's observables on, of `particles`; at most a hundred blocks, each of at least one interval.
/// Empty where there is no interval.
GasBlocks gas_blocks(const fields::TimeSeries& series, std::size_t first, double particles);

}  // namespace shaken::run
