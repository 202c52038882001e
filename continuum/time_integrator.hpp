// SPDX-License-Identifier: MIT
// Strong-stability-preserving Runge-Kutta methods as tables of weights; the loop over the stages is written once, in
// the stepper. Shu & Osher 1988; Gottlieb, Ketcheson & Shu 2009.
#pragma once

#include <array>
#include <span>

namespace shaken::continuum {

/// The two weights of a stage add up to one exactly, in binary too, or mass would leak 5e-17 a step.
/// One stage: u = start * u_n + previous * (u + dt * rhs(u, t + time * dt)).
struct Stage {
    double start, previous;
    double time;  // of the argument of rhs, in units of the step
};

inline constexpr std::array<Stage, 1> forward_euler{{{0.0, 1.0, 0.0}}};
inline constexpr std::array<Stage, 2> ssp_rk2{{{0.0, 1.0, 0.0}, {0.5, 0.5, 1.0}}};
inline constexpr std::array<Stage, 3> ssp_rk3{
    {{0.0, 1.0, 0.0}, {3.0 / 4.0, 1.0 / 4.0, 1.0}, {1.0 - 2.0 / 3.0, 2.0 / 3.0, 0.5}}};

}  // namespace shaken::continuum
