// SPDX-License-Identifier: MIT
// `shaken md` and `shaken continuum`: one engine of a scene into a run folder, from the start or from a checkpoint.
#pragma once

#include <string>

#include "app/options.hpp"
#include "scene/scene.hpp"

namespace shaken::app {

/// Throws scene::SceneError where a command of both engines is given a homogeneous gas.
void refuse_uniform(const scene::Scene& scene, const std::string& command);

/// Throws scene::SceneError where an engine other than the continuum is asked for a scene with an exact solution.
void refuse_verification(const scene::Scene& scene, const std::string& command);

/// Both return an exit code (done or stopped) and throw what goes wrong.
int run_md(const EngineOptions& options);
int run_continuum(const EngineOptions& options);

}  // namespace shaken::app
