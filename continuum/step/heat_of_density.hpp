// SPDX-License-Identifier: MIT
// The heat that the density gradient drives, q = -mu_n grad n (Garzo & Dufty 1999), in the implicit step of a column.
// Through the face between a cell and the next one above, in a step,
//     F = w (T_0 - T_1) + (a_0 T_0 + a_1 T_1),   a = dt/(2 dz^2) n mu_n/T (n_0 - n_1)/((n_0 + n_1)/2),
// w the coupling of conduction. n mu_n is finite in the vacuum, and so is the jump of density over its mean. With
// mu_n/T from the start of the step F is linear in the new temperatures, F = up T_0 - down T_1, and nothing limits the
// step: with up and down not negative the solution is positive, however long it is. Where a of the cell that gains is
// above w, the rest of its part is taken in proportion to the temperature of the cell that loses; at rest that is the
// same F.
#pragma once

#include <cmath>
#include <cstdint>

#include "continuum/flux/wave_speeds.hpp"

namespace shaken::continuum {

/// What a face carries up of a unit of temperature below it, and down of one above.
struct HeatCouplings {
    double up, down;
};

struct HeatCell {
    double density, temperature;
    double density_conductivity;  // mu_n at T = 1
};

/// Of the face between `below` and `above`; scale = dt/(2 dz^2).
inline HeatCouplings heat_couplings(const HeatCell& below, const HeatCell& above, double conduction, double scale) {
    const auto part = [&](const HeatCell& cell) {
        return scale * cell.density * cell.density_conductivity * std::sqrt(cell.temperature);
    };
    const double jump = 2.0 * (below.density - above.density) / (below.density + above.density);
    const HeatCell &loser = jump > 0.0 ? below : above, &gainer = jump > 0.0 ? above : below;
    const double lost = std::abs(jump) * part(loser), gained = std::abs(jump) * part(gainer);
    const double by_gainer = smaller(gained, conduction);
    const double leaving = conduction + (lost + (gained - by_gainer) * (gainer.temperature / loser.temperature));
    const double returning = conduction - by_gainer;
    return jump > 0.0 ? HeatCouplings{leaving, returning} : HeatCouplings{returning, leaving};
}

}  // namespace shaken::continuum
