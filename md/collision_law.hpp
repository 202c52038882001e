// SPDX-License-Identifier: MIT
// What a collision does to velocities: the normal part of the relative velocity is reversed and multiplied by the
// restitution e, the tangential part is untouched, momentum is kept (smooth spheres of equal mass).
#pragma once

#include <algorithm>
#include <cmath>

namespace shaken::md {

/// What the normal velocity gains and what is lost. Speeds along the normal, positive when approaching.
struct PairImpulse {
    double factor;  // first gains factor * r, second loses it; r from first to second, not normalised
    double loss;    // of kinetic energy: (1 - e^2) (v.n)^2 / 4 for particles of mass 1
};

/// r = x2 - x1 at contact (length 1 to round-off), r_dot_v = r.(v2 - v1) < 0, r_squared = r.r.
template <class Law>
PairImpulse collide_pair(double r_dot_v, double r_squared, const Law& restitution) {
    const double e = restitution(-r_dot_v / std::sqrt(r_squared));
    return {0.5 * (1.0 + e) * r_dot_v / r_squared, 0.25 * (1.0 - e * e) * r_dot_v * r_dot_v / r_squared};
}

struct WallImpulse {
    double velocity;  // of the particle along the normal, after
    double work;      // of the wall on the particle: impulse times wall velocity
    double loss;      // of kinetic energy in the wall's frame: (1 - e^2) (v - w)^2 / 2
};

/// A wall of infinite mass moving at wall_velocity along the normal; side is +1 for a wall below the particle, -1 for
/// one above. A rebound slower than slowest_rebound (relative to the wall) leaves at that speed instead: the cut-off of
/// the infinite sequence of bounces of a particle that comes to rest on the wall. Its gain of energy is a negative
/// loss, so the ledger still closes. A velocity that recedes already, by round-off, counts as rest on the wall.
template <class Law>
WallImpulse collide_wall(double velocity, double wall_velocity, double side, const Law& restitution,
                         double slowest_rebound) {
    const double relative = velocity - wall_velocity;
    const double approach = std::max(0.0, -side * relative);
    const double rebound = std::max(restitution(approach) * approach, slowest_rebound);
    const double after = wall_velocity + side * rebound;
    return {after, (after - velocity) * wall_velocity, 0.5 * (relative * relative - rebound * rebound)};
}

}  // namespace shaken::md
