// SPDX-License-Identifier: MIT
// What the values of a scene imply, and what they may not contradict.
#pragma once

#include "scene/scene.hpp"

namespace shaken::scene {

/// Fills the derived members (motion, number_of_particles, depth), then asks the owners of keys. Throws SceneError.
void resolve(Scene& scene);

}  // namespace shaken::scene
