// SPDX-License-Identifier: MIT
#include "md/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "md/errors.hpp"
#include "md/event_loop.hpp"

namespace md {

double choose_shell(const Setup& setup) {
    const Box& box = setup.box;
    double shortest = std::min(box.x, box.y);
    if (box.periodic_z) shortest = std::min(shortest, box.z);
    const double allowed = 0.5 * (0.5 * shortest - 1.0);
    constexpr double narrowest = 0.05;
    if (allowed < narrowest)
        throw CannotSetUp(fmt::format("md: a periodic box must measure at least {} diameters, not {}",
                                      2.0 + 4.0 * narrowest, shortest));
    if (setup.options.shell > 0.0) return std::min(setup.options.shell, allowed);
    double wanted = 0.4;
    if (box.periodic_z) {
        const double fraction =
            static_cast<double>(setup.start.position.size()) * std::numbers::pi / 6.0 / (box.x * box.y * box.z);
        constexpr double neighbours = 14.0;
        wanted = std::cbrt(neighbours / (8.0 * fraction)) - 1.0;
    }
    return std::min(std::max(wanted, narrowest), allowed);
}

std::unique_ptr<Engine> make_engine(const Setup& setup) {
    return std::visit(
        [&]<class Law>(const Law& law) -> std::unique_ptr<Engine> {
            if (setup.box.periodic_z) return std::make_unique<EventLoop<Law, false>>(setup, law);
            return std::make_unique<EventLoop<Law, true>>(setup, law);
        },
        setup.restitution);
}

}  // namespace md
