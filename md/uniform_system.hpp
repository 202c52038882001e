// SPDX-License-Identifier: MIT
// A box periodic in all three directions, without gravity or plate: the reference state of hard-sphere theory.
#pragma once

#include <cstdint>

#include "scene/scene.hpp"

namespace shaken::md {

struct UniformSystem {
    std::int64_t particles = 4000;
    double volume_fraction = 0.3;  // the cubic box follows: L^3 = pi N / (6 nu)
    double temperature = 1.0;      // of the initial Maxwell velocities, scaled to be exact; total momentum zero
    double period = 1.0;           // length of a "cycle": the clock is rebased this often
    std::uint64_t seed = 1;
    scene::Restitution restitution = scene::RestitutionConstant{1.0};
    scene::Friction friction;
    scene::CollapseRemedy collapse = scene::CollapseRemedy::none;
    double collapse_speed = 0.01, collapse_time = 1e-4;

    double box_length() const;
};

}  // namespace shaken::md
