// SPDX-License-Identifier: MIT
// `shaken continuum` of a scene with an exact solution: prints the distance from it, leaves both profiles.
#pragma once

#include "app/options.hpp"
#include "scene/scene.hpp"

namespace shaken::app {

/// Whether scenes of this kind are run by run_verification.
bool is_verification(scene::Kind kind);
/// Writes scene.toml, verification.csv and summary.json into the folder of the options. Returns an exit code.
int run_verification(const scene::Scene& scene, const EngineOptions& options);
/// Throws scene::SceneError where an engine other than the continuum is asked for such a scene.
void refuse_verification(const scene::Scene& scene, const std::string& command);

}  // namespace shaken::app
