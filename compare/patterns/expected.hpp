// SPDX-License-Identifier: MIT
// The waves that a shaken layer is expected to have, from the scene alone.
#pragma once

#include "scene/scene.hpp"

namespace shaken::compare {

/// Wavelength of a shaken layer's pattern, lambda/H = 1.0 + 1.1 f*^-1.32 (Bizon and others 1998, as Bougie 2004,
/// figure 5.2), in sigma.
double pattern_wavelength(const scene::Scene& scene);

/// Shortest side, sigma, along which a wave fits: waves down to 0.6 of the formula's live too.
double needed_side(const scene::Scene& scene);

/// Whether a wave fits along the longer side of the box.
bool holds_pattern(const scene::Scene& scene);

/// Whether the longer side is below that and yet above 0.37 of the formula's wave, where one deep layer has a wave.
bool may_hold_pattern(const scene::Scene& scene);

}  // namespace shaken::compare
