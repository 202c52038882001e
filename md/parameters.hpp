// SPDX-License-Identifier: MIT
// The keys of a scene that the molecular dynamics owns: friction, the remedy against collapse, the ceiling, [md].
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/key_owner.hpp"
#include "scene/scene.hpp"

namespace shaken::md {

extern const scene::KeyOwner keys;

/// The scene as the MD alone knows it; keys of others are left alone. Throws as scene::read_scene does.
scene::Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

}  // namespace shaken::md
