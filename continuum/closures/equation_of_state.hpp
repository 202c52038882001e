// SPDX-License-Identifier: MIT
// Pressure, sound speed and specific heat of the granular gas a scene names, for whoever wants them at a point: the
// Mach number of a profile needs them, whichever engine made it. The solver's kernels use the same formulas inlined.
// Jenkins & Richman 1985: p = n T chi, chi = 1 + 2 (1 + e) G, G = nu g0(nu).
#pragma once

#include "scene/scene.hpp"

namespace shaken::continuum {

class EquationOfState {
  public:
    /// Compressibility chi and nu dchi/dnu at a volume fraction.
    struct Compressibility {
        double chi = 1.0;
        double slope = 0.0;
    };
    using Law = Compressibility (*)(double volume_fraction, double restitution);

    EquationOfState() = default;
    EquationOfState(Law law, double restitution, double packing)
        : law_(law), restitution_(restitution), packing_(packing) {}

    /// p in m g / sigma^2. volume_fraction in [0, packing_limit()), temperature >= 0 in g sigma.
    double pressure(double volume_fraction, double temperature) const;
    /// c = sqrt(T chi (1 + (2/3) chi + (nu/chi) dchi/dnu)), in sqrt(g sigma).
    double sound_speed(double volume_fraction, double temperature) const;
    /// c_p = 3/2 + chi^2 / (chi + nu dchi/dnu), per particle.
    double specific_heat_at_constant_pressure(double volume_fraction) const;
    /// Collisions of one particle a unit of time, (24/sqrt(pi)) G sqrt(T) = 4 n sigma^2 g0 sqrt(pi T/m), in
    /// sqrt(g/sigma) (Chapman and Cowling, with Enskog's g0 at contact).
    double collision_rate(double volume_fraction, double temperature) const;
    /// The volume fraction at which the pressure diverges.
    double packing_limit() const { return packing_; }

  private:
    Law law_ = nullptr;
    double restitution_ = 1.0;
    double packing_ = 0.65;
};

/// What the scene's [continuum] closure, pair_correlation and restitution say; throws scene::SceneError for a name
/// that is not in the table.
EquationOfState make_equation_of_state(const scene::Scene& scene);

/// The same from a pair correlation and the restitution of the pressure.
EquationOfState make_equation_of_state(const scene::Choice& pair_correlation, double restitution);

/// lambda = sqrt(pi/8) / (n pi sigma^2), in sigma; density n in particles per sigma^3.
double mean_free_path(double density);

}  // namespace shaken::continuum
