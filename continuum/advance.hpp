// SPDX-License-Identifier: MIT
// Leads a method through a stretch of time, and gives it up in words where it is no longer one: where its steps have
// become too small, where a floor holds the gas, where it makes or loses mass or energy by itself.
#pragma once

#include <functional>

#include "continuum/method.hpp"

namespace shaken::continuum {

/// Heat that the temperature floor gives to this much of the mass is no longer a correction.
inline constexpr double most_mass_at_floor = 0.5;
/// Of what a method itself may make or lose, in the balance of Method::drift.
inline constexpr double most_mass_made = 0.1, most_energy_made = 0.25;
/// Beyond it growing waves are not those of some thin gas at the edge.
inline constexpr double most_mass_unstable = 0.1;

/// In equal steps as far as the state allows, the last one ending at `to`; local time. Throws RunFailed with place and
/// time where a step below `shortest` is asked for, the floor holds, the method makes or is unstable in more than the
/// shares above. False where it was asked to stop on the way, which it is after every step.
bool advance(Method& method, double from, double to, double shortest, const std::function<bool()>& asked_to_stop = {});

}  // namespace shaken::continuum
