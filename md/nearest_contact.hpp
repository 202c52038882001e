// SPDX-License-Identifier: MIT
// The innermost loop: which neighbour a particle touches first, if both go on as they do.
#pragma once

#include <cstdint>
#include <span>

#include "md/contact_time.hpp"
#include "md/neighbour_lists.hpp"
#include "md/particle.hpp"

namespace md {

struct Contact {
    double delay;  // from now; `never` if no neighbour is touched
    std::uint32_t partner;
};

/// Of particle p, which must be at its position of `now`. Of equal times the first in the list counts.
inline Contact nearest_contact(const Particle& p, double now, std::span<const std::uint32_t> neighbours,
                               const Particle* particles, const Periodic& x, const Periodic& y, const Periodic& z) {
    Contact first{never, 0};
    for (const std::uint32_t j : neighbours) {
        const Particle& q = particles[j];
        const double flight = now - q.time;
        const double vx = q.velocity_x - p.velocity_x;
        const double vy = q.velocity_y - p.velocity_y;
        const double vz = q.velocity_z - p.velocity_z;
        const double rx = x.image(q.x + q.velocity_x * flight - p.x);
        const double ry = y.image(q.y + q.velocity_y * flight - p.y);
        const double rz = z.image(q.z + q.velocity_z * flight - p.z);
        const double r_dot_v = rx * vx + ry * vy + rz * vz;
        if (r_dot_v >= 0.0) continue;
        const double r_squared = rx * rx + ry * ry + rz * rz;
        // The contact comes no sooner than gap / (2 |r.v| / |r|...): without a root, gap / (-2 r.v).
        if (r_squared - 1.0 >= -2.0 * first.delay * r_dot_v) continue;
        const double delay = time_to_contact(r_dot_v, r_squared, vx * vx + vy * vy + vz * vz);
        if (delay < first.delay) first = {delay, j};
    }
    return first;
}

}  // namespace md
