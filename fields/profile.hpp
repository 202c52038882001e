// SPDX-License-Identifier: MIT
// Horizontally averaged fields against height above the plate at one phase. Which engine made it cannot be seen.
#pragma once

#include <numbers>
#include <vector>

#include "fields/bins.hpp"

namespace shaken::fields {

struct Profile {
    double phase = 0.0;  // ft in [0, 1)
    Bins bins;
    std::vector<double> density;        // n, per sigma^3
    std::vector<double> velocity;       // u_z in the lab frame, sqrt(g sigma); NaN where the bin is empty
    std::vector<double> temperature;    // T = <|v - u|^2>/3, g sigma; NaN where unknown (fields/phase_moments.hpp)
    std::vector<double> temperature_z;  // <(v_z - u_z)^2>
    std::vector<double> temperature_x;  // mean of the x and y parts
    double plate_height = 0.0;          // of the plate, lab frame
    double plate_velocity = 0.0;

    double volume_fraction(std::int64_t i) const {
        return density[static_cast<std::size_t>(i)] * std::numbers::pi / 6.0;
    }
    double height(std::int64_t i) const { return plate_height + bins.centre(i); }  // lab frame
};

}  // namespace shaken::fields
