// SPDX-License-Identifier: MIT
// z_cm(ft) from cycle to cycle, and its statistics. Lab frame, sigma; errors are shares of z_cm, rms over the phases.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace shaken::plan {

inline constexpr std::size_t phases = 20;

/// z_cm at twenty equal phases.
using Profile = std::array<double, phases>;

using Heights = std::vector<Profile>;  // one a cycle, from the start

/// Of cycles [first, last).
Profile mean(const Heights& heights, std::size_t first, std::size_t last);

/// a/b - 1 at each phase.
Profile deviation(const Profile& a, const Profile& b);

double root_mean_square(const Profile& deviation);

/// Root mean square over the phases of a/b - 1.
double difference(const Profile& a, const Profile& b);

/// Cycles after which every pair of cycles lies within `tolerance` of the mean of the last quarter of the record.
/// Pairs, because a layer may come back after two cycles only. Never more than three quarters of the record.
std::size_t settling_time(const Heights& heights, double tolerance);

/// What is left of the start in a mean over `cycles` after `settle` cycles: its deviation from the last quarter.
Profile left_of_start(const Heights& heights, std::size_t settle, std::size_t cycles);

/// Standard error of a mean over one cycle, were cycles independent: multiply by 1/sqrt(cycles).
struct Spread {
    double value = 0.0;
    double uncertainty = 0.0;  // relative, of value
    std::size_t blocks = 0, block = 0;
};

/// From the steps between means over neighbouring blocks of two cycles, or of more (at least six blocks) where those
/// say more by over two standard deviations: correlations are in it, a slow drift hardly. Cycles before `first` are
/// left out.
Spread spread(const Heights& heights, std::size_t first);

/// How far the last third of a record lies from a mean over `cycles` after `settle`, where that is more than three
/// times what the spread explains; else 0. An MD that still orders itself drifts for hundreds of cycles.
double drift(const Heights& heights, std::size_t settle, std::size_t cycles, double spread);

}  // namespace shaken::plan
