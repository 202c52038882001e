// SPDX-License-Identifier: MIT
// What a run folder holds of a run that has not finished, and its output made from that.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "files/checkpoint.hpp"
#include "run/driver.hpp"
#include "run/folder.hpp"
#include "scene/scene.hpp"

namespace shaken::run {

/// Whether scenes of this kind have an exact solution, and run on the continuum alone.
bool is_verification(scene::Kind kind);

/// A checkpoint as far as every run has it.
struct Resumed {
    files::CheckpointReader in;
    scene::Scene scene;
    Origin origin;
    std::int64_t next_sample = 0;
    bool is_finished = false;  // its output is written, and what was measured is no longer in the checkpoint
};

/// Throws files::NoInput or Damaged.
Resumed read_checkpoint(const EngineFiles& files);

/// Brings md.h5 and continuum.h5 of a folder to the last checkpoint of runs that were stopped or killed; leaves alone
/// what has finished or was never begun. Throws files::CannotCreate where the run is at work, Damaged.
void restore_outputs(const std::filesystem::path& folder);

}  // namespace shaken::run
