// SPDX-License-Identifier: MIT
// Runs of the kinds riemann, piston, column, wave, cooling_flow and uniform, and their distance from the exact
// solution.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace shaken::continuum {

/// One number beside what it should be, where that is known.
struct Checked {
    std::string name;
    double computed = 0.0, exact = 0.0;
    std::string why_no_exact = {};  // empty where it is known
    double relative_error() const { return exact != 0.0 ? computed / exact - 1.0 : computed; }
};

struct Verification {
    std::vector<double> height;                                                    // middles of the cells, sigma
    std::vector<double> volume_fraction, velocity, temperature;                    // computed
    std::vector<double> exact_volume_fraction, exact_velocity, exact_temperature;  // empty where none is known
    std::vector<Checked> numbers;
    /// Mean over the cells of |computed - exact| / mean of |exact| (velocity: absolute); NaN where none is known.
    double volume_fraction_error = 0.0, velocity_error = 0.0, temperature_error = 0.0;
    std::string why_no_exact;  // empty where the profiles have an exact solution
    std::int64_t steps = 0;
};

/// When a wave of sound is compared: over whole periods, after what is not of it has gone.
struct PeriodsOfWave {
    double begin, end;
};
PeriodsOfWave periods_of_wave(double time, double period);

/// Throws scene::SceneError for wrong names, std::invalid_argument for a layer.
void refuse_unverifiable(const scene::Scene& scene);

/// Throws that, and RunFailed where the method fails.
Verification verify(const scene::Scene& scene);
/// Nothing where it was asked to stop on the way.
std::optional<Verification> verify_unless(const std::function<bool()>& asked_to_stop, const scene::Scene& scene);

}  // namespace shaken::continuum
