// SPDX-License-Identifier: MIT
// The user's mistakes in a scene, each with its place: app/ turns them into exit code 65 (66 where there is no file).
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace shaken::scene {

/// A value that cannot be accepted. The message points at the place as a compiler does:
///   ch4_shock.toml:14:15: particles.restitution = 1.3 is outside [0, 1]
///      14 | restitution = 1.3
///         |               ^
struct SceneError : std::runtime_error {
    SceneError(const Place& where, const std::string& message);
    Place place;
};

/// The scene file is not there or cannot be read.
struct NoSceneFile : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// That a value of this scene cannot be accepted, at the place where its key was written, else at the scene as a whole.
SceneError refusal(const Scene& scene, const std::string& key, const std::string& message);

/// Of some known words the one nearest to what was written, or empty if none is near.
std::string nearest_word(const std::string& written, const std::vector<std::string>& known);

/// "name 'hlc' is unknown; known: hll, hllc; did you mean hllc?" at the choice's place: for the owners of tables.
SceneError unknown_choice(const std::string& parameter, const Choice& choice, const std::vector<std::string>& known);

}  // namespace shaken::scene
