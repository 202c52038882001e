// SPDX-License-Identifier: MIT
// The keys of a scene that the hydrodynamics owns: [continuum], [tube] with its initial states, the unevenness of a
// layer's start.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/key_owner.hpp"
#include "scene/scene.hpp"

namespace shaken::continuum {

extern const scene::KeyOwner keys;

/// The scene as the continuum alone knows it; keys of others are left alone. Throw as scene::read_scene does.
scene::Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});
scene::Scene parse_scene(const std::string& text, const std::string& source,
                         const std::vector<std::string>& overrides = {});

}  // namespace shaken::continuum
