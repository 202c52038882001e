// SPDX-License-Identifier: MIT
// Scenes with the keys of both engines, and whether runs of them are of one experiment.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace shaken::compare {

scene::KeyOwners both_engines();

/// scene::read_scene and parse_scene for both engines; a key that neither has is refused.
scene::Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});
scene::Scene parse_scene(const std::string& text, const std::string& source,
                         const std::vector<std::string>& overrides = {});

/// A run and the scene that it recorded.
struct RecordedRun {
    std::string engine;  // as in `shaken md`
    std::filesystem::path path;
    scene::Scene scene;
};

/// Throws files::Damaged where the two differ in what runs that are compared, or averaged, must have in common
/// (scene/differences.hpp), with the key and both values.
void refuse_other_experiment(const RecordedRun& one, const RecordedRun& other);

}  // namespace shaken::compare
