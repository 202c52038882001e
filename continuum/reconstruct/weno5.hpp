// SPDX-License-Identifier: MIT
// WENO-Z of fifth order: three parabolas over five cells, weighted by their smoothness. Jiang & Shu 1996; weights of
// Borges, Carmona, Costa & Don 2008 with power 2, which keeps the order at simple extrema.
//     | q[0] | q[1] | q[2] | q[3] | q[4] | q[5] |       below: cells 0 to 4; above: cells 5 to 1, mirrored
//                        face
// Cell values are averages of what is conserved, so mass, momentum and energy are reconstructed and turned into
// velocity and temperature at the face: fifth order in one dimension, second order where two or three mix (one value a
// face). A face where that leaves a density or temperature far from the cell's own, as on either side of the edge of a
// vacuum, and one in a strong shock (shock.hpp) take MUSCL's values.
#pragma once

#include <cmath>

#include "continuum/reconstruct/limiters.hpp"
#include "continuum/reconstruct/muscl.hpp"
#include "continuum/reconstruct/shock.hpp"

namespace shaken::continuum {

/// With `flattens`, a face in a strong shock takes MUSCL's values.
template <bool flattens = true>
struct Weno5 {
    using AcrossColumns = Weno5<false>;  // whose cells are too wide to hold a shock (shock.hpp)

    /// Value at the edge between c and d of a profile with cell averages a to e.
    [[gnu::always_inline]] static double edge(double a, double b, double c, double d, double e) {
        const double p0 = (2.0 * a - 7.0 * b + 11.0 * c) * (1.0 / 6.0);
        const double p1 = (-b + 5.0 * c + 2.0 * d) * (1.0 / 6.0);
        const double p2 = (2.0 * c + 5.0 * d - e) * (1.0 / 6.0);
        const double bend0 = a - 2.0 * b + c, bend1 = b - 2.0 * c + d, bend2 = c - 2.0 * d + e;
        const double slope0 = a - 4.0 * b + 3.0 * c, slope1 = b - d, slope2 = 3.0 * c - 4.0 * d + e;
        const double s0 = (13.0 / 12.0) * (bend0 * bend0) + 0.25 * (slope0 * slope0);
        const double s1 = (13.0 / 12.0) * (bend1 * bend1) + 0.25 * (slope1 * slope1);
        const double s2 = (13.0 / 12.0) * (bend2 * bend2) + 0.25 * (slope2 * slope2);
        // Weights d (1 + (|s0 - s2|/s)^2), brought over one denominator: one division in place of four. What is added
        // to s keeps the products of sixth order numbers.
        constexpr double never_zero = 1e-40;
        const double q0 = square(s0 + never_zero), q1 = square(s1 + never_zero), q2 = square(s2 + never_zero);
        const double global = square(s0 - s2);
        const double w0 = 0.1 * (q0 + global) * (q1 * q2);
        const double w1 = 0.6 * (q1 + global) * (q0 * q2);
        const double w2 = 0.3 * (q2 + global) * (q0 * q1);
        return (w0 * p0 + w1 * p1 + w2 * p2) / (w0 + w1 + w2);
    }

    [[gnu::always_inline]] static FaceValues below(const Stencil& s, std::int64_t f, double packing_density) {
        return guarded<0, 1, 2, 3, 4>(s, f, Limited::below(s, f, packing_density), packing_density);
    }
    [[gnu::always_inline]] static FaceValues above(const Stencil& s, std::int64_t f, double packing_density) {
        return guarded<5, 4, 3, 2, 1>(s, f, Limited::above(s, f, packing_density), packing_density);
    }

  private:
    using Limited = Muscl<LimiterVanLeer, flattens>;

    [[gnu::always_inline]] static double square(double x) { return x * x; }

    struct Conserved {
        double mass, normal, tangent_1, tangent_2, energy;
    };
    [[gnu::always_inline]] static Conserved conserved(const Stencil& s, std::size_t k, std::int64_t f) {
        const double n = s.density[k][f], u = s.normal[k][f], u1 = s.tangent_1[k][f], u2 = s.tangent_2[k][f];
        return {n, n * u, n * u1, n * u2, n * (1.5 * s.temperature[k][f] + 0.5 * (u * u + (u1 * u1 + u2 * u2)))};
    }

    /// From the cells A to E, C the one at the face.
    template <std::size_t A, std::size_t B, std::size_t C, std::size_t D, std::size_t E>
    [[gnu::always_inline]] static FaceValues guarded(const Stencil& s, std::int64_t f, const FaceValues& limited,
                                                     double packing_density) {
        const Conserved a = conserved(s, A, f), b = conserved(s, B, f), c = conserved(s, C, f), d = conserved(s, D, f),
                        e = conserved(s, E, f);
        const double density = edge(a.mass, b.mass, c.mass, d.mass, e.mass);
        const double momentum = edge(a.normal, b.normal, c.normal, d.normal, e.normal);
        const double momentum_1 = edge(a.tangent_1, b.tangent_1, c.tangent_1, d.tangent_1, e.tangent_1);
        const double momentum_2 = edge(a.tangent_2, b.tangent_2, c.tangent_2, d.tangent_2, e.tangent_2);
        const double energy = edge(a.energy, b.energy, c.energy, d.energy, e.energy);
        const double cell_density = c.mass, cell_temperature = s.temperature[C][f];
        const bool dense_enough = density > 0.3 * cell_density;
        const double per_density = 1.0 / (dense_enough ? density : cell_density);
        const double u = momentum * per_density, u1 = momentum_1 * per_density, u2 = momentum_2 * per_density;
        const double temperature = (2.0 / 3.0) * (energy * per_density - 0.5 * (u * u + (u1 * u1 + u2 * u2)));
        const bool trusted = dense_enough & (density < 2.0 * cell_density) &
                             (density < 0.5 * (packing_density + cell_density)) &
                             (temperature > 0.3 * cell_temperature) & (temperature < 3.0 * cell_temperature) &
                             !(flattens && in_strong_shock(s, f));
        return {trusted ? density : limited.density, trusted ? u : limited.normal, trusted ? u1 : limited.tangent_1,
                trusted ? u2 : limited.tangent_2, trusted ? temperature : limited.temperature};
    }
};

}  // namespace shaken::continuum
