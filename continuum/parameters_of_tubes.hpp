// SPDX-License-Identifier: MIT
#pragma once

#include "scene/parameters.hpp"

namespace shaken::continuum {

/// Shows [tube] and the initial states of a scene whose future is known, of any kind but a layer and a uniform gas.
void describe_tube(scene::Scene& scene, scene::ParameterVisitor& visitor);

}  // namespace shaken::continuum
