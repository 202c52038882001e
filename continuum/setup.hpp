// SPDX-License-Identifier: MIT
// All that a flow starts from: grid, state, ends, forces and choices. A scene becomes one of these; tests and
// verification cases build their own.
#pragma once

#include "continuum/boundary/boundaries.hpp"
#include "continuum/closures/effective_dissipation.hpp"
#include "continuum/flow.hpp"
#include "continuum/grid.hpp"
#include "scene/plate_motion.hpp"
#include "scene/scene.hpp"

namespace shaken::continuum {

struct Setup {
    Grid grid;
    Flow flow;
    Boundaries boundaries;
    scene::PlateMotion motion{0.0, 1.0};  // the frame's acceleration
    double gravity = 0.0;                 // along -z
    double restitution = 1.0;             // e of pressure and transport
    scene::Restitution sink = scene::RestitutionConstant{1.0};
    scene::Continuum choices;          // names, cfl
    double floor_temperature = 1e-30;  // in g sigma

    explicit Setup(const Grid& g) : grid(g), flow(g) {}
};

}  // namespace shaken::continuum
