// SPDX-License-Identifier: MIT
// Systems small enough to run in a blink, for the tests of this folder.
#pragma once

#include <cmath>

#include "md/simulation.hpp"
#include "md/uniform_system.hpp"
#include "scene/scene.hpp"

using namespace shaken;

namespace small {

/// A shallow layer on a 6 x 7 plate, shaken hard enough to be a fluid.
inline scene::Scene layer(std::int64_t particles = 150, scene::Restitution law = scene::RestitutionConstant{0.9}) {
    scene::Scene s;
    s.number_of_particles = particles;
    s.box = {6.0, 7.0, 60.0};
    s.particles.restitution = law;
    s.motion = scene::PlateMotion::from_acceleration(3.0, 0.2);
    s.initial.temperature = 2.0;
    return s;
}

inline md::UniformSystem gas(std::int64_t particles, double volume_fraction, double restitution = 1.0) {
    md::UniformSystem system;
    system.particles = particles;
    system.volume_fraction = volume_fraction;
    system.restitution = scene::RestitutionConstant{restitution};
    return system;
}

}  // namespace small
