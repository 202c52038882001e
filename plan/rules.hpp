// SPDX-License-Identifier: MIT
// What a scene needs at least, from its numbers alone. Each rule's measured effect is in docs/choosing.md.
#pragma once

#include <cstdint>
#include <string>

#include "scene/scene.hpp"

namespace shaken::plan {

/// Wavelength of a shaken layer's pattern, lambda/H = 1.0 + 1.1 f*^-1.32 (Bizon and others 1998, as Bougie 2004,
/// figure 5.2), in sigma.
double pattern_wavelength(const scene::Scene& scene);

/// Whether one wave fits along the longer side of the box. Waves shorter than the formula's by a tenth or so live too.
bool holds_pattern(const scene::Scene& scene);

/// 1 where nothing varies across columns, 2 where waves fit along one side alone, else 3.
int needed_dimension(const scene::Scene& scene);

struct FlatBox {
    std::int64_t number = 0;  // particles
    double side = 0.0;        // x and y, sigma
};

/// The smallest square cell that shows a flat layer's z_cm without the cell in it, with as many particles an area as
/// the scene has; the scene's own cell where that is smaller.
FlatBox flat_box(const scene::Scene& scene);

/// Width of that cell, sigma; not whole, so that no row of touching particles fits (docs/validation.md).
inline constexpr double flat_width = 10.5;

/// Cells a wavelength across columns, for a fading rate within 3 per cent: (k dx)^2/12 (docs/numerics.md).
inline constexpr double cells_a_wavelength = 10.5;

}  // namespace shaken::plan
