// SPDX-License-Identifier: MIT
// Garzo & Dufty 1999: Navier-Stokes coefficients of the revised Enskog equation for any restitution, first Sonine
// polynomial, with the heat flux along the density gradient, q = -kappa grad T - mu grad n. With the fourth cumulant
//   c* = 32 (1 - e)(1 - 2 e^2) / (81 - 17 e + 30 e^2 (1 - e))
// the cooling rate is that of a Maxwellian times 1 + (3/32) c*; its part in div u is left out. Every
// coefficient agrees, term by term, with those of an independent program (MFiX, its kinetic theory GD_99); at e = 1
// they are Enskog's, hence Jenkins and Richman's. Coefficients in units of the dilute elastic ones, eta0 = (5/16)
// sqrt(T/pi), kappa0 = (75/64) sqrt(T/pi).
#pragma once

#include <cmath>
#include <numbers>
#include <string_view>

#include "continuum/closures/jenkins_richman.hpp"

namespace shaken::continuum {

struct GarzoDufty {
    static constexpr std::string_view name = "garzo_dufty";
    static constexpr std::string_view words = "spheres of any restitution, with heat along the density gradient";
    static constexpr std::string_view reference = "Garzo & Dufty 1999";
    static constexpr bool density_drives_heat = true;
    static constexpr bool carries_between_contacts = true;

    [[gnu::always_inline]] static double cumulant(double e) {
        return 32.0 * (1.0 - e) * (1.0 - 2.0 * e * e) / (81.0 - 17.0 * e + 30.0 * e * e * (1.0 - e));
    }

    template <class PairCorrelation>
    [[gnu::always_inline]] static Transport transport(double density, double temperature, double restitution) {
        using std::numbers::pi;
        constexpr double root_pi = 1.7724538509055160;
        const double e = restitution, c = cumulant(e);
        const double nu = sphere_volume * density;
        const Contact contact = PairCorrelation::at(nu);
        const double chi = contact.g0, g = nu * chi;
        const double relative_slope = contact.slope / chi;  // nu d ln chi / d nu
        const double pressure = 1.0 + 2.0 * (1.0 + e) * g;
        const double pressure_slope = 2.0 * (1.0 + e) * g * (1.0 + relative_slope) / pressure;  // nu d ln p* / d nu

        const double cooling = (5.0 / 12.0) * (1.0 - e * e) * (1.0 + (3.0 / 32.0) * c);  // over chi
        const double rate_shear = (1.0 - 0.25 * (1.0 - e) * (1.0 - e)) * (1.0 - c / 64.0);
        const double rate_heat =
            (1.0 / 3.0) * (1.0 + e) * (1.0 + (33.0 / 16.0) * (1.0 - e) + (19.0 - 3.0 * e) / 1024.0 * c);
        const double per_chi = 1.0 / chi;

        const double shear_kinetic =
            per_chi * (1.0 - 0.4 * (1.0 + e) * (1.0 - 3.0 * e) * g) / (rate_shear - 0.5 * cooling);
        const double bulk = (128.0 / (5.0 * pi)) * (nu * g) * (1.0 + e) * (1.0 - c / 32.0);
        const double shear = shear_kinetic * (1.0 + 0.8 * (1.0 + e) * g) + 0.6 * bulk;

        const double heat_kinetic =
            per_chi * (2.0 / 3.0) / (rate_heat - 2.0 * cooling) *
            (1.0 + 0.5 * (1.0 + pressure) * c +
             0.6 * g * (1.0 + e) * (1.0 + e) * (2.0 * e - 1.0 + (0.5 * (1.0 + e) - 5.0 / (3.0 * (1.0 + e))) * c));
        const double heat = heat_kinetic * (1.0 + 1.2 * (1.0 + e) * g) +
                            (256.0 / (25.0 * pi)) * (nu * g) * (1.0 + e) * (1.0 + (7.0 / 32.0) * c);

        const double density_kinetic = 2.0 / (2.0 * rate_heat - 3.0 * cooling) *
                                       ((1.0 + relative_slope) * cooling * heat_kinetic +
                                        per_chi * ((1.0 / 3.0) * pressure * (1.0 + pressure_slope) * c -
                                                   0.8 * g * (1.0 + 0.5 * relative_slope) * (1.0 + e) *
                                                       (e * (1.0 - e) + 0.25 * (4.0 / 3.0 + e * (1.0 - e)) * c)));
        const double density_heat = density_kinetic * (1.0 + 1.2 * (1.0 + e) * g);

        const double root_t = std::sqrt(temperature);
        const double viscosity_unit = (5.0 / 16.0) / root_pi * root_t, heat_unit = (75.0 / 64.0) / root_pi * root_t;
        return {viscosity_unit * bulk, viscosity_unit * shear, heat_unit * heat,
                heat_unit * temperature / density * density_heat};
    }

    [[gnu::always_inline]] static double cooling_share(double restitution) {
        return 1.0 + (3.0 / 32.0) * cumulant(restitution);
    }

    template <class PairCorrelation>
    [[gnu::always_inline]] static double cooling_rate(double density, double restitution) {
        return cooling_share(restitution) * JenkinsRichman::cooling_rate<PairCorrelation>(density, restitution);
    }
};

}  // namespace shaken::continuum
