// SPDX-License-Identifier: MIT
// The exact solution of the Riemann problem for p = n T chi(nu), internal energy 3/2 T, no transport and no cooling
// (after Toro 2009, chapter 4, for a general equation of state). A piston is the left half of a symmetric problem.
//   shock (Hugoniot):       (3/2)(T1 - T0) = (p1 + p0)/2 (1/n0 - 1/n1),   (u1 - u0)^2 = (p1 - p0)(1/n0 - 1/n1)
//   rarefaction (isentrope): dT = (2/3) T chi dn/n,   du = -+ c dn/n
// Pressures are per sphere volume: nu stands where n does.
#pragma once

#include <vector>

#include "continuum/closures/equation_of_state.hpp"
#include "scene/scene.hpp"

namespace shaken::continuum::exact {

class Riemann {
  public:
    /// Volume fractions in (0, packing), temperatures > 0. Throws std::domain_error where the states part so fast that
    /// a vacuum opens, or meet so fast that no pressure below 1e12 times the largest of
    /// the two and of nu (jump of u)^2 holds them.
    Riemann(const scene::GasState& left, const scene::GasState& right, const EquationOfState& state);

    double pressure() const { return pressure_; }  // of the star region
    double velocity() const { return velocity_; }
    scene::GasState left_star() const { return {left_.star_density, velocity_, left_.star_temperature}; }
    scene::GasState right_star() const { return {right_.star_density, velocity_, right_.star_temperature}; }
    /// Of the wave that runs into the gas on the right: the shock, or the head of the rarefaction.
    double right_wave_speed() const { return right_.head; }

    /// The gas at distance/time = `speed` from where the two met.
    scene::GasState at(double speed) const;

  private:
    struct Point {
        double log_density, log_temperature, velocity;  // velocity gained on the way from the undisturbed gas
    };
    /// One side, seen so that its wave runs towards negative speeds (the right side is mirrored).
    struct Side {
        scene::GasState gas;
        double gas_pressure = 0.0;
        std::vector<Point> isentrope;  // densities falling
        double star_density = 0.0, star_temperature = 0.0, head = 0.0, tail = 0.0;
        bool shock = false;
    };
    struct Behind {
        double density, temperature, velocity;
    };
    double chi(double nu) const;
    double pressure_of(double nu, double temperature) const { return nu * temperature * chi(nu); }
    double sound(const Point& point) const;
    Side make_side(const scene::GasState& gas) const;
    Point follow(const Point& from, double log_density) const;
    Behind behind(const Side& side, double pressure) const;
    Behind behind_shock(const Side& side, double pressure) const;
    Behind behind_rarefaction(const Side& side, double pressure) const;
    scene::GasState sample(const Side& side, double speed) const;

    EquationOfState state_;
    Side left_, right_;
    double pressure_ = 0.0, velocity_ = 0.0;
};

}  // namespace shaken::continuum::exact
