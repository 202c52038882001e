// SPDX-License-Identifier: MIT
// The medium a scene names, by the continuum's equation of state: the Mach number of an MD profile needs one too, and
// takes the same.
#pragma once

#include "compare/mach.hpp"
#include "scene/scene.hpp"

namespace shaken::compare {

/// Sound speed is NaN at and beyond the packing limit of the equation of state, which crystals in MD exceed.
/// Throws scene::SceneError for a closure that is unknown.
Medium medium_of(const scene::Scene& scene);

}  // namespace shaken::compare
