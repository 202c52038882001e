// SPDX-License-Identifier: MIT
// Effective dissipation D(T) = <(1 - e(v)^2) v^2> / <v^2> of a restitution law, averaged over the collision flux
// p(v) ~ v exp(-v^2/(4 T)) of a Maxwellian gas (normal relative speed v). It takes the place of 1 - e^2 in the sink,
// and in the sink alone: pressure and transport keep e0, so that chi is a function of nu.
// Tabulated once by quadrature on a logarithmic grid, read by cubic interpolation: relative error below 1e-6.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/elementary.hpp"
#include "scene/restitution.hpp"
#include "scene/scene.hpp"

namespace shaken::continuum {

/// D at one temperature by quadrature, relative error below 1e-10. temperature > 0.
double effective_dissipation(const scene::Restitution& law, double temperature);

class EffectiveDissipation {
  public:
    explicit EffectiveDissipation(const scene::Restitution& law);

    bool is_constant() const { return table_.empty(); }
    double constant() const { return constant_; }

    /// D at a temperature; outside 2^-40 to 2^40 g sigma the value at the nearer end.
    double operator()(double temperature) const {
        return table_.empty() ? constant_ : interpolate(table_.data(), temperature).value;
    }

    /// For loops over cells: the table, to be handed to interpolate().
    const double* table() const { return table_.data(); }
    struct Local {
        double value;
        double slope;  // dD/d(ln T)
    };
    [[gnu::always_inline]] static Local interpolate(const double* table, double temperature) {
        double place = (scene::fast_log2(temperature) - lowest) * per_octave;
        place = place > 1.0 ? place : 1.0;
        place = place < last ? place : last;
        const std::int32_t i = static_cast<std::int32_t>(place);
        const double x = place - i;
        const double a = table[i - 1], b = table[i], c = table[i + 1], d = table[i + 2];
        const double linear = c - a, square = 2.0 * a - 5.0 * b + 4.0 * c - d, cube = 3.0 * (b - c) + d - a;
        constexpr double places_a_unit_of_ln = per_octave / 0.69314718055994531;
        return {b + 0.5 * x * (linear + x * (square + x * cube)),
                0.5 * (linear + x * (2.0 * square + 3.0 * x * cube)) * places_a_unit_of_ln};
    }

  private:
    static constexpr double lowest = -40.0, highest = 40.0, per_octave = 16.0;
    static constexpr double last = (highest - lowest) * per_octave - 2.0;
    std::vector<double> table_;
    double constant_ = 0.0;
};

/// The law of the sink: the scene's, or the constant that [continuum] restitution puts in its place.
scene::Restitution sink_restitution(const scene::Scene& scene);
/// The e of pressure and transport: e0 of that law.
double pressure_restitution(const scene::Scene& scene);

}  // namespace shaken::continuum
