// SPDX-License-Identifier: MIT
// Errors of grids each half as wide as the one before, from their differences: no exact answer is needed where the
// order is known.
#pragma once

#include <vector>

#include "plan/heights.hpp"

namespace shaken::plan {

/// Measured on one grid: z_cm by phase, its error as a share, and time and steps a cycle.
struct Level {
    double spacing = 0.0, error = 0.0, seconds = 0.0, steps = 0.0, begin = 0.0, leave = 0.0;
    Profile profile{}, deviation{};  // deviation: what error is the root mean square of, with its sign
};

/// Fills in errors and deviations of all levels, coarsest first: the finest's from its difference to the one before,
/// those of others from their difference to the finest. Of a single level nothing is known.
void tell_errors(std::vector<Level>& levels, double order);

/// The deviation of the nearest level, scaled to an error.
Profile deviation_at(const std::vector<Level>& levels, double spacing, double error);

/// A quantity between two levels by a power of the spacing, beyond the finest by the given one.
double interpolate(const std::vector<Level>& levels, double spacing, double Level::*quantity, double order);

Profile sum_of(Profile a, const Profile& b);

}  // namespace shaken::plan
