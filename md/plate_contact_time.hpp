// SPDX-License-Identifier: MIT
// When a particle in free flight meets the oscillating plate: the FIRST root of a parabola against a sine.
// The acceleration of the gap, -(1 + Gamma cos 2 pi f t), changes sign where cos 2 pi f t = -1/Gamma; between two such
// instants the gap has at most one extremum, so that each piece is searched completely: nothing can be missed.
#pragma once

#include "scene/plate_motion.hpp"

namespace shaken::md {

/// First time in [now, until] at which gap <= 0 and falling, or `never`. Lab frame, times within the cycle, gravity 1.
/// height: of the particle's lowest point at `now` (its centre less 1/2); velocity: upwards at `now`.
/// The gap at the returned time is zero to round-off of the heights and not below -1e-14 (1 + |height|).
double plate_contact_time(const scene::PlateMotion& plate, double height, double velocity, double now, double until);

}  // namespace shaken::md
