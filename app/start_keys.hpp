// SPDX-License-Identifier: MIT
// Keys of a scene that cannot act on the start that it names.
#pragma once

#include "run/notes.hpp"
#include "scene/scene.hpp"

namespace shaken::app {

/// Of the MD: seeds beside a start from a file, in which nothing is random. Seeds left at their default say nothing.
run::Notes notes_of_start(const scene::Scene& scene);

/// Of the continuum: the numbers of a wave where there is none, and initial.seed where nothing is random, unless an MD
/// beside it starts from that. Values left at their default say nothing.
run::Notes notes_of_continuum_start(const scene::Scene& scene, bool beside_md);

/// Throws scene::SceneError at initial.phase without initial.file: the random start stands at ft = 0.
void refuse_phase_without_file(const scene::Scene& scene);

}  // namespace shaken::app
