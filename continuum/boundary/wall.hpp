// SPDX-License-Identifier: MIT
// Ghost cells of a reflecting wall at rest, no heat through it:
//     | ghost | ghost | inside | inside |       u_z odd, u_x, u_y and T even about the wall. The density goes on in a
//        -u1     -u0 ||  u0        u1           straight line, since gravity gives it a slope there (dp/dz = -n g),
//                                               limited to the lesser of the two steps inside, and to what keeps the
//                                               value at the wall positive and below packing.
#pragma once

#include <cmath>
#include <cstdint>

#include "continuum/reconstruct/limiters.hpp"

namespace shaken::continuum {

/// `inside` points to the cell at the wall, `inward` is +1 at the lower end of a column and -1 at the upper.
inline void fill_even(double* inside, std::int64_t inward) {
    for (std::int64_t k = 0; k < 3; ++k) inside[-(k + 1) * inward] = inside[k * inward];
}

inline void fill_odd(double* inside, std::int64_t inward) {
    for (std::int64_t k = 0; k < 3; ++k) inside[-(k + 1) * inward] = -inside[k * inward];
}

inline void fill_density_at_wall(double* inside, std::int64_t inward, double packing_density) {
    const double n0 = inside[0];
    double step = LimiterMinmod::slope(inside[inward] - n0, inside[2 * inward] - inside[inward]);
    step = smaller(step, n0);
    step = larger(step, -(packing_density - n0));
    for (std::int64_t k = 1; k <= 3; ++k) {
        const double straight = n0 - static_cast<double>(k) * step;
        inside[-k * inward] = smaller(larger(straight, 0.5 * n0), 0.5 * (n0 + packing_density));
    }
}

}  // namespace shaken::continuum
