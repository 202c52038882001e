// SPDX-License-Identifier: MIT
// A dilute layer at rest under unit gravity on a heated bottom, with no heat flux at its top, infinitely high. With
//     p = n T,  dp/dz = -n,  q = -kappa dT/dz - mu_n dn/dz,  dq/dz = -gamma,
//     kappa = k T^(1/2),  mu_n = m T^(3/2)/n,  gamma = c n^2 T^(3/2),
// the pressure p, which is the weight above, as the height, and s = sqrt(T):
//     q = 2 (k - m) p ds/dp + m s,   dq/dp = c p s,
// whose solution without flux at p = 0 is s ~ p^-b I_-b(a p), a^2 = c/(2 (k - m)), b = m/(4 (k - m)). Where b > 0
// (Garzo & Dufty 1999) T has a minimum and rises without bound above it; b = 0 (Jenkins & Richman 1985) gives I_0. A
// layer that no lid bounds: Brey, Ruiz-Montero & Moreno 2001, Phys. Rev. E 63, 061305 (equation unchecked).
#pragma once

namespace shaken::continuum::exact {

/// Coefficients of a gas so thin that only their dependence on n and T above is left. conductivity above
/// density_conductivity.
struct DiluteGas {
    double conductivity, density_conductivity, cooling;  // k, m, c
};

/// Jenkins & Richman 1985 at G -> 0.
DiluteGas dilute_jenkins_richman(double restitution);

/// T where the weight above is p (particles per area), bottom_temperature where it is `number_per_area`. p > 0, or p =
/// 0 where density_conductivity is 0.
double heated_layer_temperature(double bottom_temperature, double number_per_area, const DiluteGas& gas,
                                double weight_above);

}  // namespace shaken::continuum::exact
