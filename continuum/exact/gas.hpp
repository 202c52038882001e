// SPDX-License-Identifier: MIT
// Exact flows of a uniform or resting gas.
#pragma once

#include "continuum/closures/equation_of_state.hpp"
#include "continuum/closures/jenkins_richman.hpp"

namespace shaken::continuum::exact {

/// Haff 1983: T(t) = T / (1 + (4/sqrt(pi)) (1 - e^2) G sqrt(T) t)^2, G = nu g0; the granular temperature of a uniform
/// gas.
double cooled_temperature(double temperature, double restitution, double contact_rate, double time);

/// The same where the sink has the effective dissipation D(T) of a restitution law in the place of 1 - e^2: the
/// ordinary differential equation dT/dt = -(8/sqrt(pi)) D(T) G T^(3/2), to a relative 1e-10.
double cooled_temperature(double temperature, const scene::Restitution& law, double contact_rate, double time);

/// Attenuation of sound of long wavelength in an elastic gas, amplitude ~ exp(-Gamma k^2 t):
///   Gamma = [ lambda + 4 mu/3 + kappa (1/c_v - 1/c_p) ] / (2 n),   c_v = 3/2    (Landau & Lifshitz 1987, eq. 79.6)
double sound_attenuation(double density, const Transport& transport, double specific_heat_at_constant_pressure);

/// Volume fraction of an isothermal column at rest under unit gravity, at a height above the bottom: dp/dz = -n at
/// T constant, so T (chi + nu dchi/dnu) dn = -n dz. Runge-Kutta of fourth order in `steps` steps.
double isothermal_volume_fraction(const EquationOfState& state, double bottom, double temperature, double height,
                                  int steps = 2000);

}  // namespace shaken::continuum::exact
