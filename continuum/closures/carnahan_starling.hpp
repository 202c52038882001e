// SPDX-License-Identifier: MIT
// Carnahan & Starling 1969, g0 = (1 - nu/2) / (1 - nu)^3, up to freezing at nu_f = 0.49; above it Torquato's (1995)
// simple pole g0(nu_f) (nu_max - nu_f) / (nu_max - nu), with nu_max = 0.65 so that both pair correlations pack alike.
// g0 is continuous at nu_f; its slope steps up by 20 %, and the sound speed with it by 4 %.
#pragma once

#include <string_view>

#include "continuum/closures/pair_correlation.hpp"

namespace shaken::continuum {

struct CarnahanStarling {
    static constexpr std::string_view name = "carnahan_starling";
    static constexpr std::string_view words = "a fluid up to freezing at 0.49, a pole at 0.65 above it";
    static constexpr std::string_view reference = "Carnahan & Starling 1969; Torquato 1995";
    static constexpr double packing = 0.65;
    static constexpr double freezing = 0.49;

    static Contact at(double volume_fraction) {
        constexpr double at_freezing =
            (1.0 - 0.5 * freezing) / ((1.0 - freezing) * (1.0 - freezing) * (1.0 - freezing));
        const double nu = volume_fraction;
        const double void_inverse = 1.0 / (1.0 - nu);
        const double fluid = (1.0 - 0.5 * nu) * (void_inverse * void_inverse * void_inverse);
        const double fluid_slope =
            nu * ((3.0 * void_inverse) * fluid - 0.5 * (void_inverse * void_inverse * void_inverse));
        const double room_inverse = 1.0 / (packing - nu);
        const double glass = at_freezing * (packing - freezing) * room_inverse;
        const double glass_slope = nu * glass * room_inverse;
        const bool dense = nu > freezing;
        return {dense ? glass : fluid, dense ? glass_slope : fluid_slope};
    }
};

}  // namespace shaken::continuum
