// SPDX-License-Identifier: MIT
// What is chosen of a Swift-Hohenberg run. Lengths in units in which the critical wavenumber is 1.
#pragma once

#include <cstdint>
#include <numbers>

namespace shaken::swift_hohenberg {

struct Parameters {
    std::int64_t points = 42;              // along each side of the square
    double side = 4.0 * std::numbers::pi;  // two critical wavelengths
    double step = 0.5;
    double control = 0.0;  // epsilon
    double noise = 0.0;    // F
    bool cubic = true;     // without: the linear equation
    double start = 1e-2;   // standard deviation of the random start at each point
    std::uint64_t seed = 1;
};

}  // namespace shaken::swift_hohenberg
