// SPDX-License-Identifier: MIT
#include <optional>

#include "continuum/boundary/named.hpp"
#include "continuum/verification/case.hpp"

namespace shaken::continuum {

using scene::GasState;

Case riemann_case(const scene::Scene& scene) {
    Case c{empty_tube(scene), {}, departure_from_euler(scene)};
    Setup& setup = c.setup;
    setup.boundaries = boundaries_of_tube(scene.tube);
    const bool piston = scene.tube.lower.name == "piston";
    GasState left = scene.tube.left, right = scene.tube.right;  // in the frame of the lower end
    for (GasState* gas : {&left, &right}) gas->velocity -= piston ? scene.tube.speed : 0.0;
    const double middle = 0.5 * scene.tube.length;
    for (std::int64_t i = 0; i < setup.grid.nz; ++i) put(setup, i, setup.grid.centre(i) < middle ? left : right);
    if (piston) c.why_no_exact = "the piston sends a wave of its own (the kind piston knows it)";
    if (!c.why_no_exact.empty()) return c;
    const std::optional<exact::Riemann> solution = solve_exactly(left, right, scene, c);
    if (!solution) return c;
    const double reach = 0.5 * scene.tube.length / scene.tube.time;
    const GasState below = solution->at(-reach), above = solution->at(reach);
    if (below.volume_fraction != left.volume_fraction || above.volume_fraction != right.volume_fraction)
        c.why_no_exact = "a wave has reached an end of the tube";
    for (std::int64_t i = 0; i < setup.grid.nz; ++i)
        c.exact.push_back(solution->at((setup.grid.centre(i) - middle) / scene.tube.time));
    return c;
}

}  // namespace shaken::continuum
