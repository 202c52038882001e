// SPDX-License-Identifier: MIT
// Transport coefficients of Jenkins & Richman 1985 (Bougie 2004, section 3.1), with all terms in 1/G:
//   lambda = (8/(3 sqrt(pi)))  n T^(1/2) G
//   mu     = (sqrt(pi)/6)      n T^(1/2) [ (5/16)/G + 1 + (4/5)(1 + 12/pi) G ]
//   kappa  = (15 sqrt(pi)/16)  n T^(1/2) [ (5/24)/G + 1 + (6/5)(1 + 32/(9 pi)) G ]
//   gamma  = (12/sqrt(pi)) D   n T^(3/2) G,   D = 1 - e^2 or the effective dissipation of the restitution law
// with G = nu g0. n/G = (6/pi)/g0 stays finite in the vacuum, so mu and kappa do, and so they are computed.
#pragma once

#include <cmath>
#include <numbers>
#include <string_view>

#include "continuum/closures/pressure.hpp"

namespace shaken::continuum {

struct Transport {
    double bulk_viscosity = 0.0;        // lambda
    double shear_viscosity = 0.0;       // mu
    double conductivity = 0.0;          // kappa, of the temperature gradient
    double density_conductivity = 0.0;  // of the density gradient: q = -kappa grad T - this grad n
};

struct JenkinsRichman {
    static constexpr std::string_view name = "jenkins_richman";
    static constexpr std::string_view words = "nearly elastic spheres, dilute to dense, all terms in 1/G";
    static constexpr std::string_view reference = "Jenkins & Richman 1985";
    static constexpr bool density_drives_heat = false;
    static constexpr bool carries_between_contacts = true;

    /// density > 0 and below packing, temperature > 0; restitution is that of fast contacts, unused here: the
    /// coefficients are those of nearly elastic spheres.
    template <class PairCorrelation>
    [[gnu::always_inline]] static Transport transport(double density, double temperature, double /*restitution*/) {
        using std::numbers::pi;
        constexpr double root_pi = 1.7724538509055160;
        const double nu = sphere_volume * density;
        const double g0 = PairCorrelation::at(nu).g0;
        const double root_t = std::sqrt(temperature);
        const double n_g = density * (nu * g0);
        const double n_over_g = (1.0 / sphere_volume) / g0;
        return {(8.0 / (3.0 * root_pi)) * root_t * n_g,
                (root_pi / 6.0) * root_t * ((5.0 / 16.0) * n_over_g + density + (0.8 * (1.0 + 12.0 / pi)) * n_g),
                (15.0 * root_pi / 16.0) * root_t *
                    ((5.0 / 24.0) * n_over_g + density + (1.2 * (1.0 + 32.0 / (9.0 * pi))) * n_g),
                0.0};
    }

    /// The cooling rate over that of a Maxwellian gas, (8/sqrt(pi)) G.
    [[gnu::always_inline]] static double cooling_share(double /*restitution*/) { return 1.0; }

    /// Rate of dT/dt = -rate D T^(3/2): (8/sqrt(pi)) G.
    template <class PairCorrelation>
    [[gnu::always_inline]] static double cooling_rate(double density, double /*restitution*/) {
        const double nu = sphere_volume * density;
        return (8.0 / 1.7724538509055160) * (nu * PairCorrelation::at(nu).g0);
    }
};

}  // namespace shaken::continuum
