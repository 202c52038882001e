// SPDX-License-Identifier: MIT
// Where a face lies in a strong shock, and slopes are made less steep: limiters near their steep end leave oscillations
// of temperature behind a strong shock as it passes from cell to cell. After the flattening of Colella & Woodward 1984,
// with a condition in velocity and temperature alone, which costs no pressure: over the six cells around the face the
// gas closes in faster than 2 sqrt(T) of the coldest and slower than that of the hottest, as it is supersonic before a
// shock and subsonic behind it. Six cells hold such a jump of a smooth flow only where they do not resolve it, so that
// no order changes; across columns cells are too wide for that, and nothing is flattened there.
#pragma once

#include <cmath>
#include <cstdint>

#include "continuum/flux/wave_speeds.hpp"
#include "continuum/reconstruct/stencil.hpp"

namespace shaken::continuum {

[[gnu::always_inline]] inline bool in_strong_shock(const Stencil& s, std::int64_t f) {
    const double below = s.temperature[0][f], above = s.temperature[5][f];
    const double inside = larger(s.temperature[2][f], s.temperature[3][f]);
    const double half = 0.5 * (s.normal[0][f] - s.normal[5][f]);
    const double closing = half * std::abs(half);
    const int is_strong = closing > smaller(below, above), is_before = closing < larger(larger(below, above), inside);
    return (is_strong & is_before) != 0;
}

}  // namespace shaken::continuum
