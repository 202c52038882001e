// SPDX-License-Identifier: MIT
// Jenkins & Richman's coefficients without the terms of order 1/G (Bougie 2004, section 3.2.9): what collisions carry,
// and not what particles carry between them, so that mu and kappa vanish with the density.
//   mu     = (sqrt(pi)/6)     n T^(1/2) [ 1 + (4/5)(1 + 12/pi) G ]
//   kappa  = (15 sqrt(pi)/16) n T^(1/2) [ 1 + (6/5)(1 + 32/(9 pi)) G ]
// The source computes with these, and with artificial dissipation where the gas is thin.
#pragma once

#include <string_view>

#include "continuum/closures/jenkins_richman.hpp"

namespace shaken::continuum {

struct JenkinsRichmanDense : JenkinsRichman {
    static constexpr std::string_view name = "jenkins_richman_dense";
    static constexpr std::string_view words = "jenkins_richman without the terms in 1/G: what collisions carry";
    static constexpr std::string_view reference = "Bougie 2004, section 3.2.9";
    static constexpr bool carries_between_contacts = false;

    template <class PairCorrelation>
    [[gnu::always_inline]] static Transport transport(double density, double temperature, double /*restitution*/) {
        using std::numbers::pi;
        constexpr double root_pi = 1.7724538509055160;
        const double nu = sphere_volume * density;
        const double root_t = std::sqrt(temperature);
        const double n_g = density * (nu * PairCorrelation::at(nu).g0);
        return {(8.0 / (3.0 * root_pi)) * root_t * n_g,
                (root_pi / 6.0) * root_t * (density + (0.8 * (1.0 + 12.0 / pi)) * n_g),
                (15.0 * root_pi / 16.0) * root_t * (density + (1.2 * (1.0 + 32.0 / (9.0 * pi))) * n_g), 0.0};
    }
};

}  // namespace shaken::continuum
