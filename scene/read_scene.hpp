// SPDX-License-Identifier: MIT
// Scene files (TOML) to Scene values and back.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace shaken::scene {

/// Reads, overrides, checks and resolves. Each override is "section.key=value"; it wins over the file, and replaces
/// the file's other member of an exclusive pair (number and depth, frequency and frequency_star).
/// Throws NoSceneFile or SceneError (scene/errors.hpp). Whoever knows both engines: compare/scenes.hpp.
Scene read_scene(const std::filesystem::path& path, const KeyOwners& owners,
                 const std::vector<std::string>& overrides = {});

/// The same from text; `source` stands for the file name in messages.
Scene parse_scene(const std::string& text, const std::string& source, const KeyOwners& owners,
                  const std::vector<std::string>& overrides = {});

/// The resolved scene as TOML, without the keys that have no part in it: reading it back gives the same scene.
std::string print_scene(const Scene& scene);

/// A floating-point number in the fewest digits that read back to it, as TOML writes it (9.0, not 9).
std::string written_number(double value);

/// Every key of a kind with unit, range, default and words, as a commented TOML file.
std::string list_parameters(Kind kind, const KeyOwners& owners);

}  // namespace shaken::scene
