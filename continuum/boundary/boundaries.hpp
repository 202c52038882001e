// SPDX-License-Identifier: MIT
// What a column ends in, below and above, in the frame of the plate. The moving plate, the lid that moves with it and a
// piston (in its own frame) are all a wall at rest; so is the stress-free end, to the waves. To add a boundary: its
// name in named.cpp; if it is a new kind of end its ghosts in a header beside this one, a line in fill_ghosts and, if
// it conducts, its coupling in step/relax_column.cpp.
#pragma once

#include <optional>

namespace shaken::continuum {

enum class End {
    wall,         // u_z = 0, no shear stress, no heat unless a temperature is given
    stress_free,  // reflects as a wall does, so that no mass passes and pressure is borne, but no viscous stress; no
                  // heat
    open,         // nothing changes across it: for flows whose waves have not reached the end
    periodic,     // both ends or none
};

/// Whether waves meet their mirror image there: u_z = 0 to the explicit part of a step.
inline bool reflects(End end) { return end == End::wall || end == End::stress_free; }

struct Boundary {
    End end = End::wall;
    std::optional<double> temperature;  // of a heated wall, in g sigma
};

struct Boundaries {
    Boundary lower, upper;
};

}  // namespace shaken::continuum
