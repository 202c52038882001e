// SPDX-License-Identifier: MIT
// Flows in a tube for the tests: a column of cells without gravity, filled from functions of height.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "continuum/closures/pressure.hpp"
#include "continuum/step/evolution.hpp"

using namespace shaken;

namespace cases {

struct Point {
    double volume_fraction, velocity, temperature;
};

/// An elastic inviscid gas unless the caller changes the setup. Cell values are those at the centre.
inline continuum::Setup tube(std::int64_t cells, double length, continuum::End lower, continuum::End upper,
                             const std::function<Point(double)>& at) {
    continuum::Grid grid;
    grid.nz = cells;
    grid.dz = length / static_cast<double>(cells);
    continuum::Setup setup(grid);
    setup.boundaries.lower.end = lower;
    setup.boundaries.upper.end = upper;
    setup.choices.transport.name = "inviscid";
    for (std::int64_t i = 0; i < cells; ++i) {
        const Point p = at(grid.centre(i));
        const auto k = static_cast<std::size_t>(grid.first(0) + i);
        setup.flow.density[k] = p.volume_fraction / continuum::sphere_volume;
        setup.flow.velocity_z[k] = p.velocity;
        setup.flow.temperature[k] = p.temperature;
    }
    return setup;
}

inline void advance(continuum::Method& evolution, double duration, double from = 0.0) {
    double t = 0.0;
    while (t < duration) {
        const double dt = std::min(evolution.longest_step(), duration - t);
        evolution.step(from + t, dt);
        t += dt;
    }
}

inline std::vector<double> inside(const continuum::Evolution& evolution, const std::vector<double>& field) {
    const auto first = field.begin() + evolution.grid().first(0);
    return {first, first + evolution.grid().nz};
}

inline std::vector<double> volume_fractions(const continuum::Evolution& evolution) {
    std::vector<double> nu = inside(evolution, evolution.flow().density);
    for (double& v : nu) v *= continuum::sphere_volume;
    return nu;
}

}  // namespace cases
