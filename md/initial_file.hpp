// SPDX-License-Identifier: MIT
// The start of a run from what an earlier MD run left: its checkpoint (md.checkpoint), or a frame of its trajectory
// (md.h5). Positions, velocities and spins are taken over, and the plate's phase; the laws are the new scene's.
#pragma once

#include "md/snapshot.hpp"
#include "scene/scene.hpp"

namespace shaken::md {

/// The state in scene.initial.file, at cycle 0. Of a layer: the state at initial.phase, which must be a sample instant;
/// a checkpoint stands at one phase, a trajectory at those of its frames (one without phases is taken to stand at
/// initial.phase). Of a uniform gas: the checkpoint, or the last frame, at time 0.
/// Throws files::NoInput, files::Damaged; scene::SceneError for a phase that is not there; CannotSetUp for another
/// number of particles or another box.
Snapshot read_start(const scene::Scene& scene);

}  // namespace shaken::md
