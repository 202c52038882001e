// SPDX-License-Identifier: MIT
#include "plan/rules.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace shaken::plan {

namespace {

// Strips of ch5_stripes, 15 to 24 long: 0.11 +- 0.05 sigma at half the plate's frequency at 0.62 of the formula's wave,
// 0.49 +- 0.08 at 0.72 and above (docs/choosing.md).
constexpr double shortest_of_formula = 0.6;
// ch4_shock in square boxes: a wave of 1.00 +- 0.05 sigma at 0.40 (24 wide), none at 0.33 (20 wide); four other layers
// have none at 0.43 to 0.56 (docs/choosing.md).
constexpr double shortest_ever = 0.37;

constexpr double least_safe_restitution = 0.85;

double longer_side(const scene::Scene& scene) { return std::max(scene.box.x, scene.box.y); }
double needed_side(const scene::Scene& scene) { return shortest_of_formula * pattern_wavelength(scene); }

}  // namespace

double pattern_wavelength(const scene::Scene& scene) {
    const double frequency_star = scene.motion.frequency * std::sqrt(scene.depth);
    return scene.depth * (1.0 + 1.1 * std::pow(frequency_star, -1.32));
}

bool holds_pattern(const scene::Scene& scene) { return longer_side(scene) >= needed_side(scene); }

bool may_hold_pattern(const scene::Scene& scene) {
    return !holds_pattern(scene) && longer_side(scene) >= shortest_ever * pattern_wavelength(scene);
}

int needed_dimension(const scene::Scene& scene) {
    if (!holds_pattern(scene)) return 1;
    return std::min(scene.box.x, scene.box.y) >= needed_side(scene) ? 3 : 2;
}

bool may_collapse(const scene::Scene& scene) {
    const auto* constant = std::get_if<scene::RestitutionConstant>(&scene.particles.restitution);
    return constant && constant->e0 < least_safe_restitution && scene.particles.collapse == scene::CollapseRemedy::none;
}

FlatBox flat_box(const scene::Scene& scene) {
    if (scene.box.x * scene.box.y <= flat_width * flat_width)
        return {scene.number_of_particles, scene.box.x, scene.box.y};
    const auto number = std::llround(scene.number_per_area() * flat_width * flat_width);
    const double side = std::sqrt(static_cast<double>(number) / scene.number_per_area());
    return {number, side, side};
}

}  // namespace shaken::plan
