// SPDX-License-Identifier: MIT
// What the hydrodynamics refuses of a scene's sizes before anything is made, with an estimate of what they ask for.
#pragma once

#include "scene/scene.hpp"

namespace shaken::continuum {

/// Throws scene::SceneError, at the key's place: grids too coarse or larger than a machine holds, averages that are so,
/// an upper end inside the layer, temperatures of ends that are not heated, a column that would cool.
void check_sizes(const scene::Scene& scene);

}  // namespace shaken::continuum
