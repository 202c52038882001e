// SPDX-License-Identifier: MIT
// The cooling flow of a dilute inelastic gas towards a wall: pressure makes gas stream to where it has cooled, until
// the density diverges there (Fouxon, Meerson, Assaf & Livne 2007). An exact solution of the inviscid equations with
// their sink at chi = 1. In the mass coordinate m (particles per area from the wall), with n the number density:
//   p = A cos(kappa m),  n^(-1/2) = n0^(-1/2) - (L/(2 gamma)) sqrt(p) t,
//   kappa = L/(sqrt(2) gamma),  gamma = 5/3,  L = (4 sqrt(pi)/3) (1 - e^2),
// up to kappa m = pi/2, where p = 0: a free surface, above which there is nothing.
#pragma once

#include "scene/scene.hpp"

namespace shaken::continuum::exact {

class CoolingFlow {
  public:
    /// A gas of one density throughout; `wall` gives it and the temperature at the wall at the start. restitution < 1.
    CoolingFlow(const scene::GasState& wall, double restitution);

    /// Height of the free surface. time in [0, longest_time()).
    double surface(double time) const;
    /// When the density at the wall diverges, sqrt(sigma/g).
    double longest_time() const;
    /// Above the surface: volume fraction and temperature 0, the velocity of the surface.
    scene::GasState at(double height, double time) const;

  private:
    double integral_of_root(double mass) const;  // of sqrt(cos(kappa m)) from the wall
    double height_of(double mass, double time) const;

    double density_, pressure_, kappa_, rate_;  // n0, A, kappa, L/(2 gamma)
    double mass_, integral_;                    // up to the surface
};

}  // namespace shaken::continuum::exact
