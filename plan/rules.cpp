// SPDX-License-Identifier: MIT
#include "plan/rules.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace shaken::plan {

namespace {

constexpr double least_safe_restitution = 0.85;

}  // namespace

int needed_dimension(const scene::Scene& scene) {
    if (!holds_pattern(scene)) return 1;
    return std::min(scene.box.x, scene.box.y) >= compare::needed_side(scene) ? 3 : 2;
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
