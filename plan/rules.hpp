// SPDX-License-Identifier: MIT
// What a scene needs at least, from its numbers alone. Each rule's measured effect is in docs/choosing.md.
#pragma once

#include <cstdint>
#include <string>

#include "compare/patterns/expected.hpp"
#include "scene/scene.hpp"

namespace shaken::plan {

using compare::holds_pattern;
using compare::may_hold_pattern;
using compare::pattern_wavelength;

/// 1 where nothing varies across columns, 2 where waves fit along one side alone, else 3.
int needed_dimension(const scene::Scene& scene);

/// Whether grains of this law may collapse in a cell as small as flat_width: constant e below 0.85 without a remedy. At
/// e = 0.75 four of six seeds do within 30 cycles of ch4_shock, at 0.8 two of six within 40, and none in its own cell,
/// which also remembers itself for tens of cycles at 0.8, as the small one does not (docs/choosing.md).
bool may_collapse(const scene::Scene& scene);

struct FlatBox {
    std::int64_t number = 0;  // particles
    double x = 0.0, y = 0.0;  // sigma
};

/// A square cell of flat_width with as many particles an area as the scene has; the scene's own where that is smaller.
FlatBox flat_box(const scene::Scene& scene);

/// Width of that cell, sigma; not whole, so that no row of touching particles fits (docs/validation.md).
inline constexpr double flat_width = 10.5;

/// By how much z_cm differs in it from that in a cell of 20 x 20 (ch4_shock; docs/choosing.md).
inline constexpr double flat_width_error = 0.0033;

/// Cells a wavelength across columns, for a fading rate within 3 per cent: (k dx)^2/12 (docs/numerics.md).
inline constexpr double cells_a_wavelength = 10.5;

}  // namespace shaken::plan
