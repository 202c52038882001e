// SPDX-License-Identifier: MIT
#include "compare/patterns/expected.hpp"

#include <algorithm>
#include <cmath>

namespace shaken::compare {

namespace {

// Strips of ch5_stripes, 15 to 24 long: 0.11 +- 0.05 sigma at half the plate's frequency at 0.62 of the formula's wave,
// 0.49 +- 0.08 at 0.72 and above (docs/choosing.md).
constexpr double shortest_of_formula = 0.6;
// ch4_shock in square boxes: a wave of 1.00 +- 0.05 sigma at 0.40 (24 wide), none at 0.33 (20 wide); four other layers
// have none at 0.43 to 0.56 (docs/choosing.md).
constexpr double shortest_ever = 0.37;

double longer_side(const scene::Scene& scene) { return std::max(scene.box.x, scene.box.y); }

}  // namespace

double pattern_wavelength(const scene::Scene& scene) {
    const double frequency_star = scene.motion.frequency * std::sqrt(scene.depth);
    return scene.depth * (1.0 + 1.1 * std::pow(frequency_star, -1.32));
}

double needed_side(const scene::Scene& scene) { return shortest_of_formula * pattern_wavelength(scene); }

bool holds_pattern(const scene::Scene& scene) { return longer_side(scene) >= needed_side(scene); }

bool may_hold_pattern(const scene::Scene& scene) {
    return !holds_pattern(scene) && longer_side(scene) >= shortest_ever * pattern_wavelength(scene);
}

}  // namespace shaken::compare
