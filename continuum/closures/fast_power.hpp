// SPDX-License-Identifier: MIT
// x^a without calls or branches, so that loops over cells vectorise and every lane, remainder and mirrored copy gives
// the same bits. Relative error below 1e-14 for 1e-13 < x <= 2 and |a| <= 1 (measured against std::pow in
// tests/continuum/closures_tests.cpp).
#pragma once

#include "scene/elementary.hpp"

namespace shaken::continuum {

/// x^a for x >= 0 and moderate a; power(0, a) is about 1e-308^a, not 0.
[[gnu::always_inline]] inline double fast_power(double x, double a) {
    return scene::fast_exp2(a * scene::fast_log2(x));
}

}  // namespace shaken::continuum
