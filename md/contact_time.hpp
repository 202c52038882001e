// SPDX-License-Identifier: MIT
// When two spheres touch, and when one touches the fixed ceiling. An event is the first time at which the overlap
// function |r|^2 - 1 is not positive AND falling (Bannerman, Strobl, Formella, Poeschel 2014): already overlapping
// and approaching is now, overlapping and receding is never, so round-off can neither tunnel nor collide twice.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace shaken::md {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// Time from now until |r + v t| = 1, or `never`. r_dot_v = r.v, r_squared = r.r, v_squared = v.v of the straight
/// relative motion. The root is taken without cancellation; its error in |r| - 1 is round-off also at grazing.
inline double time_to_contact(double r_dot_v, double r_squared, double v_squared) {
    if (r_dot_v >= 0.0) return never;  // receding
    const double gap = r_squared - 1.0;
    const double discriminant = r_dot_v * r_dot_v - v_squared * gap;
    if (discriminant < 0.0) return never;  // passing by
    return std::max(0.0, gap / (std::sqrt(discriminant) - r_dot_v));
}

/// Time until a particle under gravity 1 meets a fixed plane above it. gap: from the particle up to the plane;
/// velocity: of the particle, upwards.
inline double time_to_ceiling(double gap, double velocity) {
    if (velocity <= 0.0) return never;
    if (gap <= 0.0) return 0.0;
    const double discriminant = velocity * velocity - 2.0 * gap;
    if (discriminant < 0.0) return never;  // turns round below the plane
    return 2.0 * gap / (velocity + std::sqrt(discriminant));
}

/// Time until |r + v t| = radius from inside: leaving a sphere. r_squared <= radius^2 up to round-off.
inline double time_to_leave(double r_dot_v, double r_squared, double v_squared, double radius_squared) {
    if (v_squared == 0.0) return never;
    const double inside = std::max(0.0, radius_squared - r_squared);
    const double root = std::sqrt(r_dot_v * r_dot_v + v_squared * inside);
    return r_dot_v > 0.0 ? inside / (root + r_dot_v) : (root - r_dot_v) / v_squared;
}

}  // namespace shaken::md
