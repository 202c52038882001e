// SPDX-License-Identifier: MIT
// Laws of normal restitution e(v_n), the same between particles, with the plate and with the ceiling.
// To add a law: a struct here with the same call operator, an alternative in Restitution, a line in parameters.cpp.
#pragma once

#include <cmath>
#include <variant>

namespace shaken::scene {

/// e independent of the approach speed.
struct RestitutionConstant {
    double e0 = 0.9;
    double operator()(double /*normal_speed*/) const { return e0; }
};

/// e(v) = 1 - (1 - e0) (v/v0)^(3/4) below v0, e0 above: slow contacts are elastic (Bizon and others 1998;
/// Bougie 2004, eq. 3.29, where v0 = sqrt(g sigma)).
struct RestitutionVelocity {
    double e0 = 0.7;
    double v0 = 1.0;
    double operator()(double normal_speed) const {
        const double ratio = std::abs(normal_speed) / v0;
        if (ratio >= 1.0) return e0;
        const double root = std::sqrt(ratio);
        return 1.0 - (1.0 - e0) * root * std::sqrt(root);
    }
};

using Restitution = std::variant<RestitutionConstant, RestitutionVelocity>;

/// The restitution of fast contacts, which every law names e0.
inline double fast_restitution(const Restitution& law) {
    return std::visit([](const auto& l) { return l.e0; }, law);
}

}  // namespace shaken::scene
