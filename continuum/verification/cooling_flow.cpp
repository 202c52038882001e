// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "continuum/closures/closures.hpp"
#include "continuum/exact/cooling_flow.hpp"
#include "continuum/verification/case.hpp"
#include "scene/errors.hpp"

namespace shaken::continuum {

using scene::GasState;

Case cooling_flow_case(const scene::Scene& scene) {
    Case c{empty_tube(scene), {}, ""};
    if (scene.tube.restitution == 1.0)
        throw scene::SceneError({}, "tube.restitution = 1: a gas that does not cool has no cooling flow");
    const exact::CoolingFlow flow(scene.tube.gas, scene.tube.restitution);
    if (scene.tube.time >= flow.longest_time())
        throw scene::SceneError({}, fmt::format("tube.time = {} is not below {:.6g}, when the density diverges",
                                                scene.tube.time, flow.longest_time()));
    if (scene.tube.length < flow.surface(0.0))
        throw scene::SceneError({}, fmt::format("tube.length = {} does not hold the warm gas, {:.6g} high",
                                                scene.tube.length, flow.surface(0.0)));
    c.setup.boundaries.lower.end = End::wall;
    c.setup.boundaries.upper.end = End::open;
    // Above the surface there should be nothing; so little does nothing to the flow below.
    constexpr double nothing = 1e-9;
    c.setup.floor_temperature = nothing * scene.tube.gas.temperature;
    for (std::int64_t i = 0; i < c.setup.grid.nz; ++i) {
        GasState gas = flow.at(c.setup.grid.centre(i), 0.0);
        gas.volume_fraction = std::max(gas.volume_fraction, nothing * scene.tube.gas.volume_fraction);
        gas.temperature = std::max(gas.temperature, c.setup.floor_temperature);
        put(c.setup, i, gas);
        c.exact.push_back(flow.at(c.setup.grid.centre(i), scene.tube.time));
    }
    std::vector<double> volume_fractions;
    for (const GasState& gas : c.exact) volume_fractions.push_back(gas.volume_fraction);
    c.why_no_exact = departure_from_dilute(volume_fractions);
    if (scene.continuum.transport.name != "inviscid")
        c.why_no_exact = "the exact solution has continuum.transport = \"inviscid\"";
    else if (traits_of(scene.continuum.closure).cooling_share(scene.tube.restitution) != 1.0)
        c.why_no_exact =
            fmt::format("the exact solution cools as a Maxwellian gas, and {} does not", scene.continuum.closure.name);
    return c;
}

}  // namespace shaken::continuum
