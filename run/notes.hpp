// SPDX-License-Identifier: MIT
// What a reader must know before the numbers of a continuum run: where the equations leave something out, and where
// they do not hold. One list of sentences, which the terminal, continuum.h5, summary.json and the report all show.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace shaken::run {

/// One sentence each.
using Notes = std::vector<std::string>;

/// What follows from the scene alone; of the kind layer.
Notes notes_of_scene(const scene::Scene& scene);

/// What the mean normal force on the upper end, over the layer's weight, says of its height: whether gas reaches it.
Notes notes_of_upper_end(const scene::Scene& scene, double force_over_weight);

/// As continuum.h5 keeps them: a line each.
std::string joined(const Notes& notes);
Notes parted(const std::string& lines);

}  // namespace shaken::run
