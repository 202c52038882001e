// SPDX-License-Identifier: MIT
// The ends of a column by name. All are walls in a frame that moves with the lower one, or no walls at all:
//     name         what it is                                                    where
//     plate        reflects; moves with the plate of the scene                   below a layer
//     stress_free  reflects, bears pressure but no viscous stress; moves so too  above a layer, unless scheme is ftcs
//     lid          reflects; moves with the plate                                above a layer
//     wall         reflects; at rest                                             tubes
//     heated       reflects, and is at a given temperature; moves as the above   everywhere
//     piston       reflects; moves into the gas at constant speed                below a tube
//     open         nothing changes across it                                     tubes
//     periodic     the other end                                                 tubes, both or none
// Which one a layer gets that names none above it: scene/resolve.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continuum/boundary/boundaries.hpp"
#include "scene/scene.hpp"

namespace shaken::continuum {

/// An end as a scene writes it: its key (continuum.lower), its name and the temperature that belongs to "heated".
struct NamedEnd {
    std::string key;
    scene::Choice name;
    std::optional<double> temperature;
    std::vector<std::string> allowed;
};

/// Throws scene::SceneError, with the place, for a name that is not allowed there, a heated end without a temperature,
/// a temperature without a heated end, and a periodic end opposite one that is not.
Boundaries named_boundaries(const NamedEnd& lower, const NamedEnd& upper);

std::vector<std::string> ends_below_layer();
std::vector<std::string> ends_above_layer();

/// Of a layer: [continuum] lower, upper.
Boundaries boundaries_of_layer(const scene::Continuum& continuum);
/// Of the kind riemann: [tube] lower, upper.
Boundaries boundaries_of_tube(const scene::Tube& tube);

}  // namespace shaken::continuum
