// SPDX-License-Identifier: MIT
// The hot record of one particle: everything a contact prediction reads, in one cache line.
#pragma once

#include <cstdint>

namespace shaken::md {

/// Position and velocity at the particle's own time, in the engine's moving frame (md/moving_frame.hpp).
struct alignas(64) Particle {
    double x = 0.0, y = 0.0, z = 0.0;
    double velocity_x = 0.0, velocity_y = 0.0, velocity_z = 0.0;
    double time = 0.0;        // within the cycle, when x, y, z were true
    std::uint32_t stamp = 0;  // how often the velocity has changed: predictions carry it, so stale ones show
    std::uint32_t id = 0;     // number in the initial state, the same for a whole run

    void move_to(double now) {
        const double flight = now - time;
        x += velocity_x * flight;
        y += velocity_y * flight;
        z += velocity_z * flight;
        time = now;
    }
};
static_assert(sizeof(Particle) == 64);

}  // namespace shaken::md
