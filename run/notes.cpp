// SPDX-License-Identifier: MIT
#include "run/notes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "compare/patterns/expected.hpp"
#include "continuum/initial_state.hpp"

namespace shaken::run {

namespace {

bool waves_fit(const scene::Scene& scene) { return compare::holds_pattern(scene) || compare::may_hold_pattern(scene); }

std::string waves_that_fit(const scene::Scene& scene) {
    return fmt::format("Waves some {:.3g} sigma long fit in the box of {:g} x {:g}", compare::pattern_wavelength(scene),
                       scene.box.x, scene.box.y);
}

}  // namespace

Notes notes_of_scene(const scene::Scene& scene) {
    Notes notes;
    if (scene.particles.friction.law != scene::FrictionLaw::none)
        notes.emplace_back("The continuum has no friction: particles.friction acts in the MD alone.");
    // By what runs, not by the word in the scene: a resumed run knows its scene with "auto" already resolved.
    const bool one_column = continuum::resolve_dimension(scene) == 1;
    if (one_column && waves_fit(scene))
        notes.push_back(waves_that_fit(scene) +
                        ", but the continuum takes one column: continuum.dimension = \"auto\" with initial.noise = "
                        "0.01 lets them grow.");
    if (!one_column && !scene.initial.uneven() && scene.initial.file.empty())
        notes.emplace_back("All columns start equal and stay equal: initial.noise (0.01, say) lets waves grow.");
    return notes;
}

Notes notes_of_upper_end(const scene::Scene& scene, double force_over_weight) {
    // ch4_shock: 2e-4 goes with a shift of z_cm by 0.07 %, 3e-6 with 0.001 % (docs/numerics.md).
    constexpr double of_gas = 1e-4;
    if (std::abs(force_over_weight) <= of_gas) return {};
    return {fmt::format(
        "The upper end at continuum.lid = {:g} bears {:.2g} of the layer's weight (limit {:g}): gas reaches "
        "it, and its height shapes the answer; raise continuum.lid.",
        scene.continuum.lid, force_over_weight, of_gas)};
}

std::string joined(const Notes& notes) {
    std::string lines;
    for (const std::string& note : notes) lines += note + "\n";
    return lines;
}

Notes parted(const std::string& lines) {
    Notes notes;
    std::istringstream in(lines);
    for (std::string note; std::getline(in, note);) notes.push_back(note);
    return notes;
}

}  // namespace shaken::run
