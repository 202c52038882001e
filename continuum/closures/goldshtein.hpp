// SPDX-License-Identifier: MIT
// Goldshtein, Shapiro & Gutfinger 1996, as used by Bougie 2004: g0 = 1 / (1 - (nu/nu_max)^(4 nu_max/3)), nu_max = 0.65.
// Diverges at random close packing; 11 to 21 % below Carnahan and Starling at nu = 0.2 to 0.45.
#pragma once

#include <string_view>

#include "continuum/closures/fast_power.hpp"
#include "continuum/closures/pair_correlation.hpp"

namespace shaken::continuum {

struct Goldshtein {
    static constexpr std::string_view name = "goldshtein";
    static constexpr std::string_view words = "one formula up to packing at 0.65; 11 to 21 % low at nu = 0.2 to 0.45";
    static constexpr std::string_view reference = "Goldshtein, Shapiro & Gutfinger 1996";
    static constexpr double packing = 0.65;

    static Contact at(double volume_fraction) {
        constexpr double exponent = 4.0 * packing / 3.0;
        const double q = fast_power(volume_fraction * (1.0 / packing), exponent);
        const double g0 = 1.0 / (1.0 - q);
        return {g0, exponent * q * (g0 * g0)};
    }
};

}  // namespace shaken::continuum
