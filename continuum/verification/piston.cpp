// SPDX-License-Identifier: MIT
#include <optional>

#include "continuum/verification/case.hpp"

namespace shaken::continuum {

using scene::GasState;

Case piston_case(const scene::Scene& scene) {
    Case c{empty_tube(scene), {}, departure_from_euler(scene)};
    Setup& setup = c.setup;
    setup.boundaries.upper.end = End::open;
    GasState gas = scene.tube.gas;  // in the frame of the piston
    gas.velocity = -scene.tube.speed;
    for (std::int64_t i = 0; i < setup.grid.nz; ++i) put(setup, i, gas);
    if (!c.why_no_exact.empty()) return c;
    GasState image = gas;
    image.velocity = scene.tube.speed;
    const std::optional<exact::Riemann> solution = solve_exactly(image, gas, scene, c);
    if (!solution) return c;
    for (std::int64_t i = 0; i < setup.grid.nz; ++i)
        c.exact.push_back(solution->at(setup.grid.centre(i) / scene.tube.time));
    return c;
}

}  // namespace shaken::continuum
