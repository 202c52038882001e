// SPDX-License-Identifier: MIT
// A case: how a flow with a known future starts, and what is known of its end. One file a kind of scene.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "continuum/closures/equation_of_state.hpp"
#include "continuum/exact/riemann.hpp"
#include "continuum/method.hpp"
#include "continuum/setup.hpp"
#include "continuum/verification.hpp"

namespace shaken::continuum {

struct Case {
    Setup setup;
    std::vector<scene::GasState> exact;  // at the middles of the cells; empty where there is none
    std::string why_no_exact;
};

// Each throws scene::SceneError for values that leave no such flow.
Case riemann_case(const scene::Scene& scene);
Case piston_case(const scene::Scene& scene);
Case column_case(const scene::Scene& scene);
Case wave_case(const scene::Scene& scene);
Case uniform_case(const scene::Scene& scene);
Case cooling_flow_case(const scene::Scene& scene);

using AskedToStop = std::function<bool()>;

/// Leads the method through the wave's time and puts down its speed and damping; false where it was asked to stop on
/// the way.
bool check_wave(const scene::Scene& scene, Method& method, double shortest, const AskedToStop& asked_to_stop,
                Verification& v);
/// Puts down the temperatures of a column on a heated bottom, at its end; nothing without such a bottom.
void check_heated(const scene::Scene& scene, const Method& method, Verification& v);

// What several cases share.

EquationOfState state_of(const scene::Scene& scene);
/// A tube of length and spacing of the scene, walls at its ends, its gas still to be put in.
Setup empty_tube(const scene::Scene& scene);
void put(Setup& setup, std::int64_t cell, const scene::GasState& gas);
double duration_of(const scene::Scene& scene);

/// Whether the flow obeys Euler's equations; if not, says what keeps it from them.
std::string departure_from_euler(const scene::Scene& scene);
/// Whether the gas is thin enough for exact solutions of a dilute one; if not, says so.
std::string departure_from_dilute(const std::vector<double>& volume_fractions);
/// The exact solution; where there is none, says why and leaves the case without.
std::optional<exact::Riemann> solve_exactly(const scene::GasState& left, const scene::GasState& right,
                                            const scene::Scene& scene, Case& c);

/// The fields of the one column, cell by cell.
struct Inside {
    std::vector<double> volume_fraction, velocity, temperature;
};
Inside inside(const Method& method);

}  // namespace shaken::continuum
