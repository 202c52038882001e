// SPDX-License-Identifier: MIT
// docs/scene_keys.md: every key of every kind of scene, and the names that keys are chosen from.
#pragma once

#include <string>

#include "scene/key_owner.hpp"

namespace shaken::scene {

/// As Markdown: a table a section, a line a key, and a table a list of names.
std::string key_reference(const KeyOwners& owners);

/// The names alone, as comments of TOML, a line a name.
std::string list_names(const KeyOwners& owners);

}  // namespace shaken::scene
