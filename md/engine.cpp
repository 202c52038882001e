// SPDX-License-Identifier: MIT
#include "md/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "md/errors.hpp"

namespace shaken::md {

double choose_shell(const Setup& setup) {
    const Box& box = setup.box;
    double shortest = std::min(box.x, box.y);
    if (box.periodic_z) shortest = std::min(shortest, box.z);
    const double allowed = 0.5 * (0.5 * shortest - 1.0);
    constexpr double narrowest = 0.05;
    if (allowed < narrowest)
        throw CannotSetUp(fmt::format("md: a periodic box must measure at least {} diameters, not {}",
                                      2.0 + 4.0 * narrowest, shortest));
    double widest = 1.0;   // found by bench/md.md
    if (box.periodic_z) {  // in a dilute system 16 neighbours lie farther off: 8 phi r^3 of them within r
        const double per_volume = static_cast<double>(setup.start.position.size()) / (box.x * box.y * box.z);
        widest = std::max(widest, 1.1 * scene::cube_root(16.0 * 3.0 / (4.0 * std::numbers::pi * per_volume)) - 1.0);
    }
    return std::min(setup.options.shell > 0.0 ? setup.options.shell : widest, allowed);
}

std::unique_ptr<Engine> make_engine(const Setup& setup) {
    return setup.friction ? make_frictional_engine(setup) : make_smooth_engine(setup);
}

}  // namespace shaken::md
