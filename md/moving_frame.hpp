// SPDX-License-Identifier: MIT
// The frame the engine computes in: it falls freely, so every particle flies straight, and starts each epoch with the
// mean velocity of the layer, so that a layer moving as a body hardly moves and keeps its neighbours.
#pragma once

namespace shaken::md {

/// height_lab = z + displacement(t), velocity_lab = velocity_z + velocity(t); at `start` both heights agree.
struct MovingFrame {
    double start = 0.0;  // time within the cycle
    double initial_velocity = 0.0;
    double gravity = 1.0;  // 0 in a box without it

    double displacement(double t) const {
        const double elapsed = t - start;
        return elapsed * (initial_velocity - 0.5 * gravity * elapsed);
    }
    double velocity(double t) const { return initial_velocity - gravity * (t - start); }
};

}  // namespace shaken::md
