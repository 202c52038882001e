// SPDX-License-Identifier: MIT
// The equation of state shared by all closures here: p = n T chi(nu), chi = 1 + 2 (1 + e) nu g0(nu), internal energy
// 3/2 n T (Jenkins & Richman 1985; the same in Garzo & Dufty 1999). Inlined into the kernels.
#pragma once

#include <numbers>

#include "continuum/closures/pair_correlation.hpp"

namespace shaken::continuum {

/// Volume fraction of unit spheres at number density 1.
inline constexpr double sphere_volume = std::numbers::pi / 6.0;

struct PressurePoint {
    double pressure = 0.0;
    double sound_speed_squared = 0.0;
};

/// chi and nu dchi/dnu from the contact value; `virial` = 2 (1 + e).
inline double compressibility(double volume_fraction, const Contact& contact, double virial) {
    return 1.0 + virial * (volume_fraction * contact.g0);
}
inline double compressibility_slope(double volume_fraction, const Contact& contact, double virial) {
    return virial * (volume_fraction * (contact.g0 + contact.slope));
}

template <class PairCorrelation>
[[gnu::always_inline]] inline PressurePoint pressure_point(double density, double temperature, double virial) {
    const double nu = sphere_volume * density;
    const Contact contact = PairCorrelation::at(nu);
    const double chi = compressibility(nu, contact, virial);
    const double slope = compressibility_slope(nu, contact, virial);
    return {density * temperature * chi, temperature * (chi * (1.0 + (2.0 / 3.0) * chi) + slope)};
}

}  // namespace shaken::continuum
