// SPDX-License-Identifier: MIT
// Where a run starts: spheres without overlap in a slab or a periodic box, disordered by Monte Carlo moves from a
// thinned lattice, with Maxwell velocities. A function of the seed alone.
#pragma once

#include <cstdint>

#include "md/audit.hpp"
#include "md/snapshot.hpp"

namespace shaken::md {

struct InitialState {
    std::int64_t particles = 0;
    double volume_fraction = 0.3;  // a slab's height follows: N pi/6 / (area nu)
    double temperature = 1.0;      // <|v|^2>/3, exact; the total momentum is zero
    std::uint64_t seed = 1;
};

/// A flat layer on the plate at its lowest position, or a uniform periodic box (box.periodic_z, which must have the
/// volume that the volume fraction asks for). Throws CannotSetUp if the particles do not fit.
Snapshot make_initial_state(const InitialState& state, const Box& box);

}  // namespace shaken::md
