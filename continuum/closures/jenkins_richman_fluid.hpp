// SPDX-License-Identifier: MIT
// Jenkins & Richman 1985 with the contact value that they wrote, Carnahan & Starling's (1969), in the coefficients
//   G_t = nu (1 - nu/2) / (1 - nu)^3
// at every density: transport grows on smoothly as in a fluid, by a factor of 4.5 from freezing
// (0.49) to packing (0.65), where the pressure and the cooling rate, with the pair correlation of the run, diverge.
#pragma once

#include <string_view>

#include "continuum/closures/jenkins_richman.hpp"

namespace shaken::continuum {

/// Carnahan & Starling's contact value of the fluid, without a pole at packing.
struct FluidContact {
    static Contact at(double volume_fraction) {
        const double void_inverse = 1.0 / (1.0 - volume_fraction);
        return {(1.0 - 0.5 * volume_fraction) * (void_inverse * void_inverse * void_inverse), 0.0};
    }
};

struct JenkinsRichmanFluid : JenkinsRichman {
    static constexpr std::string_view name = "jenkins_richman_fluid";
    static constexpr std::string_view words =
        "jenkins_richman with a fluid's contact value: transport stays finite at packing";
    static constexpr std::string_view reference = "Jenkins & Richman 1985; Carnahan & Starling 1969";

    template <class PairCorrelation>
    [[gnu::always_inline]] static Transport transport(double density, double temperature, double restitution) {
        return JenkinsRichman::transport<FluidContact>(density, temperature, restitution);
    }
};

}  // namespace shaken::continuum
