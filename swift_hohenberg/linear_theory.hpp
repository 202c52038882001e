// SPDX-License-Identifier: MIT
// The equation without its cubic term, mode by mode.
#pragma once

#include <cstdint>

#include "swift_hohenberg/parameters.hpp"

namespace shaken::swift_hohenberg {

/// Squared wavenumber of the mode (i, j) of the discrete transform, 0 <= i, j < points.
inline double squared_wavenumber(const Parameters& p, std::int64_t i, std::int64_t j) {
    const auto signed_index = [&](std::int64_t m) { return static_cast<double>(2 * m > p.points ? m - p.points : m); };
    const double unit = 2.0 * std::numbers::pi / p.side;
    const double kx = unit * signed_index(i), ky = unit * signed_index(j);
    return kx * kx + ky * ky;
}

/// Growth rate epsilon - (1 - k^2)^2.
inline double growth_rate(const Parameters& p, std::int64_t i, std::int64_t j) {
    const double detuning = 1.0 - squared_wavenumber(p, i, j);
    return p.control - detuning * detuning;
}

/// <psi^2> of the linear equation below onset: the sum over the modes of this grid of F / (area (-rate))
/// (fluctuation-dissipation; Hohenberg and Swift 1992). Needs control < 0.
inline double mean_square(const Parameters& p) {
    double sum = 0.0;
    for (std::int64_t i = 0; i < p.points; ++i)
        for (std::int64_t j = 0; j < p.points; ++j) sum -= p.noise / (p.side * p.side * growth_rate(p, i, j));
    return sum;
}

}  // namespace shaken::swift_hohenberg
