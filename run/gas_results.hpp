// SPDX-License-Identifier: MIT
// The numbers of a homogeneous gas: temperature, fourth cumulant, pressure, collision rate and (of an elastic gas)
// self-diffusion, with standard errors that know how long the gas remembers, beside what the literature says.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fields/time_series.hpp"
#include "scene/scene.hpp"

namespace shaken::run {

/// A mean over the averaging time beside its reference.
struct Measured {
    std::string name;
    double value = 0.0, error = 0.0;  // standard error; NaN of a single sample
    double independent = 0.0;         // samples that would have this error without memory (fields/memory.hpp)
    bool is_too_short = false;        // to tell the error: it is what the memory found gives, at least
    std::optional<double> reference;
    std::string source;  // of the reference
};

/// Twice the intervals in which velocities are forgotten: by twenty collisions of a particle, and by the slowest shear
/// wave of the box, whose decay carries the tail of the velocity correlation (Alder and Wainwright 1970), to exp(-3).
/// In the second half displacements grow by 6 D t. 0 where the gas has no steady state, or moves too far between
/// samples to be followed through the box.
std::int64_t diffusion_window(const scene::Scene& scene);

/// Of the averaging time so far, from the observables of md.h5; empty before its first interval has passed.
std::vector<Measured> gas_results(const scene::Scene& scene, const fields::TimeSeries& series);
/// The same as summary.json.
std::string gas_summary(const std::vector<Measured>& results);

}  // namespace shaken::run
