// SPDX-License-Identifier: MIT
// The numbers of a comparison, as JSON. Layout in docs/formats.md. Each MD number has its standard error beside it
// (`..._error`: from blocks of cycles left out); what is unknown is null.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "compare/analysis.hpp"
#include "scene/scene.hpp"

namespace shaken::compare {

/// What an engine spent; measured by whoever ran it. Absent: not measured, null in the JSON.
struct Cost {
    std::optional<double> wall_seconds = {}, cpu_seconds = {};
    std::optional<double> collisions_per_particle_per_cycle = {};  // MD: pair events / N
    std::optional<double> collisions_per_particle_per_cycle_error = {};
    std::optional<double> steps_per_cycle = {};  // continuum
};

/// The phases of a cycle at which z_cm is compared.
inline constexpr std::int64_t compared_phases = 20;

/// Root mean square of (continuum - MD)/MD over compared_phases equal phases a cycle, in percent. Noise of MD adds the
/// mean square of its relative standard errors to the square of this. `lift` is added to the continuum's heights (half
/// a diameter, where its floor is taken to be the lowest plane of centres).
double centre_of_mass_rms_percent(const std::vector<double>& continuum, const std::vector<double>& md,
                                  double lift = 0.0, std::int64_t cycles = 1);

/// Which part of a shock's life is compared.
enum class Life { formation_to_leaving, fully_formed_to_leaving };

/// Root mean square of the difference of shock locations, sigma, over the phases at which both have a shock in the
/// layer; NaN where there is no such phase. `lift` as above.
double shock_location_rms(const Analysis& continuum, const Analysis& md, double lift = 0.0,
                          Life life = Life::formation_to_leaving);

/// Root mean square of the difference of a field over the layer and the cycle, as a share of the field's own root mean
/// square in MD: over all phases and all bins in which MD's volume fraction exceeds the layer's threshold. Velocities
/// are relative to the plate; bins in which either is unknown do not count. The continuum is read `lift` lower,
/// linearly between bins (half a diameter: its floor is the lowest plane of centres).
enum class Field { density, velocity, temperature };
double profile_rms(const Analysis& continuum, const Analysis& md, Field field, double lift = 0.0);

nlohmann::ordered_json summarise(const Measured& md, const Measured& continuum, const scene::Scene& scene,
                                 const Cost& md_cost, const Cost& continuum_cost);

}  // namespace shaken::compare
