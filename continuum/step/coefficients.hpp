// SPDX-License-Identifier: MIT
// Transport coefficients of every cell at T = 1. Each is a function of density times a power of T, and density does not
// change while a step relaxes: they are taken once a step.
#pragma once

#include <cstdint>
#include <vector>

#include "continuum/step/fluid.hpp"

namespace shaken::continuum {

struct Coefficients {
    std::vector<double> bulk, shear, conductivity, density_conductivity, cooling;  // (ny, nx, stride) each

    explicit Coefficients(const Grid& grid)
        : bulk(grid.size(), 0.0), shear(bulk), conductivity(bulk), density_conductivity(bulk), cooling(bulk) {}

    /// From the cell at `first` on.
    TransportArrays from(std::int64_t first) {
        return {bulk.data() + first, shear.data() + first, conductivity.data() + first,
                density_conductivity.data() + first, cooling.data() + first};
    }
};

}  // namespace shaken::continuum
