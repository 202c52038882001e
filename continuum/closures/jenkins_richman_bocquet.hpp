// SPDX-License-Identifier: MIT
// Jenkins & Richman 1985 with the shear viscosity of Bocquet, Losert, Schalk, Lubensky & Gollub 2002 (Phys. Rev. E 65,
// 011307): sheared beads show that it diverges as (1 - nu/nu_max)^(-1.75), where all else does as the inverse. So
//   mu = mu_JR (1 - nu/nu_max)^(-0.75),
// which leaves the dilute gas as it is.
#pragma once

#include <cmath>
#include <string_view>

#include "continuum/closures/jenkins_richman.hpp"

namespace shaken::continuum {

struct JenkinsRichmanBocquet : JenkinsRichman {
    static constexpr std::string_view name = "jenkins_richman_bocquet";
    static constexpr std::string_view words =
        "jenkins_richman with a viscosity that diverges faster at packing, by the power 1.75";
    static constexpr std::string_view reference = "Bocquet and others 2002, Phys. Rev. E 65, 011307";

    template <class PairCorrelation>
    [[gnu::always_inline]] static Transport transport(double density, double temperature, double restitution) {
        Transport t = JenkinsRichman::transport<PairCorrelation>(density, temperature, restitution);
        const double root = std::sqrt(1.0 - sphere_volume * density * (1.0 / PairCorrelation::packing));
        t.shear_viscosity /= root * std::sqrt(root);
        return t;
    }
};

}  // namespace shaken::continuum
