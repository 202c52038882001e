// SPDX-License-Identifier: MIT
// The ends of a column by name (named.cpp has the list). All are walls in a frame that moves with the lower one, or no
// walls at all. Which one a layer gets that names none above it: continuum/resolve.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continuum/boundary/boundaries.hpp"
#include "scene/parameters.hpp"
#include "scene/scene.hpp"

namespace shaken::continuum {

/// An end as a scene writes it: its key (continuum.lower), its name and the temperature that belongs to "heated".
struct NamedEnd {
    std::string key;
    scene::Choice name;
    std::optional<double> temperature;
    std::vector<scene::Name> allowed;
};

/// Throws scene::SceneError, with the place, for a name that is not allowed there, a heated end without a temperature,
/// a temperature without a heated end, and a periodic end opposite one that is not.
Boundaries named_boundaries(const NamedEnd& lower, const NamedEnd& upper);

/// The names there are, with words.
std::vector<scene::Name> ends_below_layer();
std::vector<scene::Name> ends_above_layer();
std::vector<scene::Name> ends_below_tube();
std::vector<scene::Name> ends_above_tube();

/// Of a layer: [continuum] lower, upper.
Boundaries boundaries_of_layer(const scene::Continuum& continuum);
/// Of the kind riemann: [tube] lower, upper.
Boundaries boundaries_of_tube(const scene::Tube& tube);

}  // namespace shaken::continuum
