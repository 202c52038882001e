// SPDX-License-Identifier: MIT
// What the engine shows of itself at one instant. Units: sigma, sqrt(sigma/g), particle mass.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace shaken::md {

/// Positions and velocities at one instant, lab frame; the order is the particle's number, the same for a whole run.
struct Snapshot {
    std::int64_t cycle = 0;                        // periods of the plate completed
    double time_in_cycle = 0.0;                    // since the start of that cycle
    std::vector<std::array<double, 3>> position;   // (N, 3), wrapped into [0, L) along periodic axes
    std::vector<std::array<double, 3>> velocity;   // (N, 3)
    std::vector<std::array<double, 3>> spin = {};  // (N, 3), angular velocity; empty where particles do not rotate
};

/// Energies now, and what each exchange summed to since the start, so that
/// kinetic + rotational + potential = initial + plate_work + ceiling_work - collision_loss - plate_loss - ceiling_loss.
/// A wall's work is impulse times its velocity; its loss is what restitution takes in the wall's own frame.
struct Ledger {
    double kinetic = 0.0, rotational = 0.0, potential = 0.0;
    double plate_work = 0.0, ceiling_work = 0.0;
    double collision_loss = 0.0, plate_loss = 0.0, ceiling_loss = 0.0;
    std::array<double, 3> momentum{};  // now
    double plate_impulse = 0.0;        // vertical momentum given by the plate since the start
    double virial = 0.0;               // sum over pair collisions of r_ij . dp_i, for the pressure

    /// Adds what was exchanged in a further stretch of time; energies and momentum are of an instant, and stay.
    Ledger& operator+=(const Ledger& more) {
        plate_work += more.plate_work;
        ceiling_work += more.ceiling_work;
        collision_loss += more.collision_loss;
        plate_loss += more.plate_loss;
        ceiling_loss += more.ceiling_loss;
        plate_impulse += more.plate_impulse;
        virial += more.virial;
        return *this;
    }
};

struct Counters {
    std::int64_t pair_collisions = 0, plate_collisions = 0, ceiling_collisions = 0;
    std::int64_t other_events = 0;  // neighbourhoods left, predictions found out of date
    double deepest_contact = 0.0;   // largest overlap at which a pair has collided, sigma: round-off
};

/// One contact that has just been dealt with.
struct ContactEvent {
    enum class Kind : std::int64_t { pair, plate, ceiling };
    Kind kind = Kind::pair;
    std::int64_t first = -1, second = -1;  // particle numbers; second = -1 for a wall
    std::int64_t cycle = 0;
    double time_in_cycle = 0.0;
};

}  // namespace shaken::md
