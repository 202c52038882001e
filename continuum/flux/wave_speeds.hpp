// SPDX-License-Identifier: MIT
// Slowest and fastest wave of a Riemann problem, after Davis 1988 and Einfeldt 1988, widened so that the state between
// them stays below packing: two streams of density n that meet at u_l > u_r leave n* = a (n_l + n_r) / (2 a - du)
// between waves at u_l - a and u_r + a, and n* < n_c asks for a > n_c du / (2 n_c - n_l - n_r). For strong shocks
// this a is the shock's own kinematic speed at full compression, which the sound speeds of cold gas do not know.
#pragma once

#include <algorithm>
#include <cmath>

#include "continuum/flux/face_state.hpp"

namespace shaken::continuum {

struct WaveSpeeds {
    double slowest, fastest;
    double signal;
};

/// Both return b if a is not a number: a bound comes first, so that what is bounded shows when it is not one.
[[gnu::always_inline]] inline double larger(double a, double b) { return a > b ? a : b; }
[[gnu::always_inline]] inline double smaller(double a, double b) { return a < b ? a : b; }

/// Least half-width that keeps the compressed state halfway between the denser side and packing.
[[gnu::always_inline]] inline double kinematic_speed(double density_left, double density_right, double closing_speed,
                                                     double packing_density) {
    const double densest = 0.5 * (packing_density + larger(density_left, density_right));
    return densest * larger(closing_speed, 0.0) / (2.0 * densest - (density_left + density_right));
}

[[gnu::always_inline]] inline WaveSpeeds wave_speeds(const FaceState& left, const FaceState& right,
                                                     double packing_density) {
    const double a = larger(larger(left.sound_speed, right.sound_speed),
                            kinematic_speed(left.density, right.density, left.normal - right.normal, packing_density));
    const double mean = 0.5 * (left.normal + right.normal);
    return {smaller(left.normal, mean) - a, larger(right.normal, mean) + a,
            larger(std::abs(left.normal), std::abs(right.normal)) + a};
}

}  // namespace shaken::continuum
