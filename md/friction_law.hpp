// SPDX-License-Identifier: MIT
// What friction does to the tangential velocities and the spins of two spheres in contact: Walton 1993, as Bizon and
// others 1998 use it. A contact sticks and gives back the fraction beta0 of its tangential velocity, reversed, or it
// slides with Coulomb's friction mu.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace shaken::md {

using Vector3 = std::array<double, 3>;

inline Vector3 cross(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// K = 4 I/(m sigma^2) of a uniform sphere.
inline constexpr double sphere_inertia = 0.4;

struct WaltonFriction {
    double beta0 = 0.35;
    double mu = 0.5;
    double per_inertia = 1.0 / sphere_inertia;  // 1/K; 0: no spins (K to infinity)
};

/// Whether the partner moves as freely as the particle or is a wall of infinite mass.
enum class Partner { sphere, wall };

struct TangentialImpulse {
    Vector3 velocity{};  // gained by a; a sphere b loses as much
    Vector3 spin{};      // gained by a, and by a sphere b as well
    double loss = 0.0;   // of kinetic energy, of motion and rotation together
};

/// n: unit vector from a to b. v = v_a - v_b and spins = w_a + w_b before the contact (a wall's spin is 0); e: normal
/// restitution of this contact. The normal impulse comes beside this one (md/collision_law.hpp).
inline TangentialImpulse collide_tangentially(const Vector3& n, const Vector3& v, const Vector3& spins, double e,
                                              const WaltonFriction& friction, Partner partner) {
    const double normal = dot(v, n);
    const Vector3 turning = cross(spins, n);
    // v_s = v - (v.n) n + (sigma/2) (w_a + w_b) x n
    Vector3 slip;
    for (std::size_t k = 0; k < 3; ++k) slip[k] = v[k] - normal * n[k] + 0.5 * turning[k];
    const double speed = std::sqrt(dot(slip, slip));
    if (speed == 0.0) return {};
    // beta = min(beta0, mu (1 + e)(1 + 1/K)|v_n|/|v_s| - 1)
    const double inertia = 1.0 + friction.per_inertia;
    const double beta = std::min(friction.beta0, friction.mu * (1.0 + e) * inertia * std::abs(normal) / speed - 1.0);
    const double share = partner == Partner::wall ? 2.0 : 1.0;
    // a gains -K (1 + beta) v_s / (2 (K + 1)), both spins -(1 + beta) (n x v_s) / ((K + 1) sigma), so v_s -> -beta v_s
    const double push = -share * (1.0 + beta) / (2.0 * inertia);
    const double turn = -share * (1.0 + beta) * friction.per_inertia / inertia;
    const Vector3 around = cross(n, slip);
    TangentialImpulse impulse;
    for (std::size_t k = 0; k < 3; ++k) {
        impulse.velocity[k] = push * slip[k];
        impulse.spin[k] = turn * around[k];
    }
    // impulse times the mean of v_s before and after
    impulse.loss = share * (1.0 - beta * beta) * speed * speed / (4.0 * inertia);
    return impulse;
}

}  // namespace shaken::md
