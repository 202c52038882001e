// SPDX-License-Identifier: MIT
// What the values of a scene imply, and what they may not contradict.
#pragma once

#include <map>
#include <string>

#include "scene/scene.hpp"

namespace shaken::scene {

/// Fills the derived members (motion, number_of_particles, depth). `places` maps "section.key" to where it was written,
/// `whole` stands for the scene where nothing was. Throws SceneError.
void resolve(Scene& scene, const std::map<std::string, Place>& places, const Place& whole);

}  // namespace shaken::scene
