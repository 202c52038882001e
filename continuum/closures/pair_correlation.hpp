// SPDX-License-Identifier: MIT
// What a pair correlation at contact g0(nu) tells the closures that use it.
#pragma once

namespace shaken::continuum {

struct Contact {
    double g0 = 1.0;     // chance of finding a neighbour at contact, over that of an ideal gas
    double slope = 0.0;  // nu dg0/dnu
};

}  // namespace shaken::continuum
