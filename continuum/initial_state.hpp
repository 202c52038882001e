// SPDX-License-Identifier: MIT
// From a scene to the setup of a flow: grid, dimension, and the flat layer it starts as.
#pragma once

#include "continuum/setup.hpp"
#include "scene/scene.hpp"

namespace shaken::continuum {

/// Cells as near to the scene's spacings as divide the lid and the sides of the box evenly.
/// Throws scene::SceneError for an unknown dimension, and for fewer than 16 cells below the lid.
Grid make_grid(const scene::Scene& scene);

/// 1, 2 or 3 as the scene's [continuum] dimension says. "auto": 1 if the layer starts uniform in x and y, 2 if one
/// side of the box is shorter than two depths (no wave fits along it: the shortest are four depths long), 3 otherwise.
/// Throws scene::SceneError for another word.
int resolve_dimension(const scene::Scene& scene);

/// A flat layer at rest on the plate at its lowest point: [initial] volume_fraction up to the height that holds the
/// particles (the topmost cell takes the rest), the density floor above, one temperature throughout. With noise each
/// column's density is multiplied by 1 + noise * (uniform in [-1, 1)), the mean kept.
/// Throws scene::SceneError where the layer does not fit below the lid or is denser than the pair correlation packs,
/// and where the scene cannot be resolved (continuum/resolve.hpp).
Setup make_setup(const scene::Scene& scene);

}  // namespace shaken::continuum
