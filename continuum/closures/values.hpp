// SPDX-License-Identifier: MIT
// What a closure says of a gas at one point, for whoever asks by name: checks against exact flows, `shaken closure`.
#pragma once

#include "continuum/closures/jenkins_richman.hpp"
#include "scene/scene.hpp"

namespace shaken::continuum {

struct ClosureValues {
    double pressure = 0.0;     // p, m g/sigma^2
    double sound_speed = 0.0;  // c, sqrt(g sigma)
    Transport transport;  // lambda, mu, kappa: m sqrt(g/sigma)/sigma; of the density gradient m g sigma^3 sqrt(g/sigma)
    double cooling =
        0.0;  // gamma = (12/sqrt(pi)) (1 - e^2) n G T^(3/2) and what the closure makes of it, m g sqrt(g/sigma)/sigma^2
};

/// At volume_fraction in (0, packing), temperature > 0 (g sigma) and a constant restitution in [0, 1]. Throws
/// scene::SceneError for a name that is in no list, std::invalid_argument for a number outside these ranges.
ClosureValues closure_values(const scene::Choice& closure, const scene::Choice& pair_correlation,
                             double volume_fraction, double temperature, double restitution);

}  // namespace shaken::continuum
