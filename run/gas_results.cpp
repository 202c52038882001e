// SPDX-License-Identifier: MIT
#include "run/gas_results.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>

#include "fields/memory.hpp"
#include "md/hard_sphere_theory.hpp"
#include "run/gas_blocks.hpp"
#include "scene/schedule.hpp"

namespace shaken::run {

namespace {

namespace theory = md::theory;

/// The constant restitution of smooth spheres, where the scene has one.
std::optional<double> constant_restitution(const scene::Scene& scene) {
    const auto* constant = std::get_if<scene::RestitutionConstant>(&scene.particles.restitution);
    const bool plain = scene.particles.friction.law == scene::FrictionLaw::none &&
                       scene.particles.collapse == scene::CollapseRemedy::none;
    return constant && plain ? std::optional(constant->e0) : std::nullopt;
}

Measured mean_of(std::string name, std::span<const double> samples, std::optional<double> reference,
                 std::string source) {
    const fields::MeanWithMemory found = fields::mean_with_memory(samples);
    const double independent = static_cast<double>(samples.size()) / (2.0 * found.memory);
    return {std::move(name), found.mean, found.error, independent, !found.is_long_enough, reference, std::move(source)};
}

/// The growth of T^(-7/8) in the second half of the time over that in the first, from the growth in each interval.
Measured later_growth(const std::vector<double>& late) {
    const auto half = late.size() / 2;
    const Measured early = mean_of("", std::span(late).first(half), std::nullopt, "");
    const Measured later = mean_of("", std::span(late).subspan(half), std::nullopt, "");
    const double ratio = later.value / early.value;
    return {"growth of T^(-7/8), second half / first",
            ratio,
            std::abs(ratio) * std::hypot(early.error / early.value, later.error / later.value),
            std::min(early.independent, later.independent),
            early.is_too_short || later.is_too_short,
            1.0,
            "T ~ t^(-8/7), the limit of T far below v0^2"};
}

}  // namespace

std::int64_t diffusion_window(const scene::Scene& scene) {
    if (constant_restitution(scene) != 1.0) return 0;
    const double root = std::sqrt(scene.initial.temperature);
    constexpr double fastest = 6.0;  // in sqrt(T): one particle in 10^7 is faster
    if (fastest * root * scene.uniform.interval > 0.5 * scene.box.x) return 0;
    const double phi = scene.initial.volume_fraction, wave_number = 2.0 * std::numbers::pi / scene.box.x;
    const double kinematic_viscosity = theory::viscosity(phi) / (6.0 * phi / std::numbers::pi);
    const double forgets =
        std::max(20.0 / theory::collision_rate(phi), 3.0 / (kinematic_viscosity * wave_number * wave_number)) / root;
    return 2 * std::max<std::int64_t>(1, std::llround(std::ceil(forgets / scene.uniform.interval)));
}

std::vector<Measured> gas_results(const scene::Scene& scene, const fields::TimeSeries& series) {
    const auto first = static_cast<std::size_t>(scene::Schedule(scene).settling_samples());
    if (series.rows() < first + 2) return {};
    const auto count = static_cast<double>(scene.number_of_particles);
    const double phi = scene.initial.volume_fraction;
    const auto at = [&](std::size_t row, const char* column) { return series.value(row, column); };
    const GasBlocks blocks = gas_blocks(series, first, count);
    const std::optional<double> e = constant_restitution(scene);
    std::vector<Measured> all;
    const Measured a2 = mean_of("fourth cumulant a2", blocks.cumulant, std::nullopt, "");
    const std::string klm = "Kolafa, Labik and Malijevsky 2004";
    const std::string of_few = " for N particles (Lebowitz and Percus 1961)";
    const std::string inelastic = e == 1.0 ? "" : ", to first order in the measured a2";
    all.push_back(mean_of("compressibility Z = p/(nT)", blocks.compressibility,
                          e ? std::optional(theory::compressibility(phi, *e, count)) : std::nullopt,
                          (e == 1.0 ? klm : klm + " times (1 + e)/2") + of_few));
    if (e == 1.0)
        all.push_back(mean_of("compressibility Z = p/(nT)", blocks.compressibility,
                              theory::compressibility_carnahan_starling(phi, count),
                              "Carnahan and Starling 1969" + of_few));
    all.push_back(
        mean_of("collision rate / sqrt(T)", blocks.rate,
                e ? std::optional(theory::collision_rate(phi, e == 1.0 ? 0.0 : a2.value, count)) : std::nullopt,
                "Enskog with chi of " + klm + of_few + inelastic));
    all.push_back(a2);
    if (e) {
        all.back().reference = e == 1.0 ? -2.0 / (3.0 * count - 1.0) : theory::cooling_cumulant(*e);
        all.back().source =
            e == 1.0 ? "Maxwell, of N particles with one energy" : "van Noije and Ernst 1998, first order";
    }
    if (e && *e < 1.0)
        all.push_back(mean_of("growth of 1/sqrt(T)", blocks.cooling, theory::cooling_rate(phi, *e, a2.value, count),
                              "Haff 1983 with chi of " + klm + of_few + inelastic));
    if (std::holds_alternative<scene::RestitutionVelocity>(scene.particles.restitution)) {
        const auto power = [&](std::size_t row) { return std::pow(at(row, "temperature"), -0.875); };
        std::vector<double> late;
        for (std::size_t row = first + 1; row < series.rows(); ++row)
            late.push_back((power(row) - power(row - 1)) / scene.uniform.interval);
        if (late.size() > 1) all.push_back(later_growth(late));
    }
    if (const std::int64_t window = diffusion_window(scene); window > 0) {
        std::vector<double> diffusion;
        const auto w = static_cast<std::size_t>(window);
        for (std::size_t end = first + w; end < series.rows(); end += w) {
            const double grown = at(end, "mean_square_displacement") - at(end - w / 2, "mean_square_displacement");
            const double root = std::sqrt(at(end, "temperature"));
            diffusion.push_back(grown / (6.0 * static_cast<double>(w / 2) * scene.uniform.interval * root));
        }
        if (!diffusion.empty())
            all.push_back(mean_of("self-diffusion / sqrt(T)", diffusion, theory::self_diffusion(phi, scene.box.x),
                                  "Erpenbeck and Wood 1991 in a cube of this side (Yeh and Hummer 2004)"));
    }
    // The theory of the fluid ends where it freezes; of the crystal the pressure is known.
    if (phi > theory::freezing) {
        for (Measured& m : all)
            if (m.name != a2.name) m.reference.reset();
        if (e == 1.0 && phi >= theory::melting) {
            all.front().reference = theory::compressibility_crystal(phi);
            all.front().source = "Speedy 1998, infinite face-centred cubic crystal";
        }
    }
    return all;
}

std::string gas_summary(const std::vector<Measured>& results) {
    nlohmann::ordered_json summary = nlohmann::ordered_json::array();
    for (const Measured& m : results) {
        nlohmann::ordered_json entry{{"name", m.name},
                                     {"measured", m.value},
                                     {"standard_error", m.error},
                                     {"independent_samples", m.independent},
                                     {"too_short", m.is_too_short}};
        if (m.reference) {
            entry["reference"] = *m.reference;
            entry["source"] = m.source;
        }
        summary.push_back(entry);
    }
    return summary.dump(2) + "\n";
}

}  // namespace shaken::run
