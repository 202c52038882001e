// SPDX-License-Identifier: MIT
// Whether runs that are averaged are independent: an average over k copies of one run has the error of one, not
// 1/sqrt(k) of it. Grains that collide are chaotic, so that two runs meet in the bits of z_cm only where they are one
// trajectory.
#pragma once

#include <filesystem>
#include <vector>

#include "scene/scene.hpp"

namespace shaken::compare {

/// A run of the MD: its file, its scene, z_cm of what it averaged, (cycles, phases), NaN where not sampled.
struct AveragedRun {
    std::filesystem::path path;
    scene::Scene scene;
    std::vector<double> centre_of_mass;
};

/// Throws files::Damaged, with both names, at the first two that are one file, that start alike (equal seeds and no
/// initial.file), or that share a tenth of a cycle or more. Samples at one instant may agree: a start that fills a
/// lattice has one z_cm whatever its seed.
void refuse_dependent(const std::vector<AveragedRun>& runs);

}  // namespace shaken::compare
