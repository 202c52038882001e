// SPDX-License-Identifier: MIT
#include "plan/rules.hpp"

#include <algorithm>
#include <cmath>

namespace shaken::plan {

namespace {

constexpr double shortest_of_formula = 0.85;

double needed_side(const scene::Scene& scene) { return shortest_of_formula * pattern_wavelength(scene); }

}  // namespace

double pattern_wavelength(const scene::Scene& scene) {
    const double frequency_star = scene.motion.frequency * std::sqrt(scene.depth);
    return scene.depth * (1.0 + 1.1 * std::pow(frequency_star, -1.32));
}

bool holds_pattern(const scene::Scene& scene) { return std::max(scene.box.x, scene.box.y) >= needed_side(scene); }

int needed_dimension(const scene::Scene& scene) {
    if (!holds_pattern(scene)) return 1;
    return std::min(scene.box.x, scene.box.y) >= needed_side(scene) ? 3 : 2;
}

FlatBox flat_box(const scene::Scene& scene) {
    if (scene.box.x * scene.box.y <= flat_width * flat_width) return {scene.number_of_particles, 0.0};
    const auto number = std::llround(scene.number_per_area() * flat_width * flat_width);
    return {number, std::sqrt(static_cast<double>(number) / scene.number_per_area())};
}

}  // namespace shaken::plan
