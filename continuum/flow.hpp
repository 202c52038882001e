// SPDX-License-Identifier: MIT
// The state: density, velocity and temperature of every cell, ghosts included. Mass, momentum and energy are what is
// conserved; they are formed from these where they are needed, cell by cell.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "continuum/grid.hpp"

namespace shaken::continuum {

struct Flow {
    std::vector<double> density, velocity_x, velocity_y, velocity_z, temperature;  // (ny, nx, stride) each

    Flow() = default;
    explicit Flow(const Grid& grid)
        : density(grid.size(), 1.0),
          velocity_x(grid.size(), 0.0),
          velocity_y(grid.size(), 0.0),
          velocity_z(grid.size(), 0.0),
          temperature(grid.size(), 1.0) {}

    /// Names of the five arrays, in the order of fields().
    static constexpr std::array<std::string_view, 5> names{"density", "velocity_x", "velocity_y", "velocity_z",
                                                           "temperature"};
    std::array<std::vector<double>*, 5> fields() {
        return {&density, &velocity_x, &velocity_y, &velocity_z, &temperature};
    }
    std::array<const std::vector<double>*, 5> fields() const {
        return {&density, &velocity_x, &velocity_y, &velocity_z, &temperature};
    }
};

}  // namespace shaken::continuum
