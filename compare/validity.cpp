// SPDX-License-Identifier: MIT
#include "compare/validity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/layer.hpp"

namespace shaken::compare {

namespace {

/// |dT/dz| in cell k, centred; one-sided at the ends of the column.
double temperature_slope(std::span<const double> temperature, std::size_t k, double spacing) {
    const std::size_t below = k == 0 ? 0 : k - 1, above = std::min(k + 1, temperature.size() - 1);
    if (above == below) return 0.0;
    return std::abs(temperature[above] - temperature[below]) / (spacing * static_cast<double>(above - below));
}

double layer_threshold(std::span<const continuum::ColumnView> columns) {
    double densest = 0.0;
    for (const continuum::ColumnView& column : columns)
        densest = std::max(densest, *std::max_element(column.density.begin(), column.density.end()));
    constexpr double layer = layer_volume_fraction / continuum::sphere_volume;
    return densest > layer ? layer : 0.5 * densest;
}

}  // namespace

Validity validity_of(std::span<const continuum::ColumnView> columns, double spacing,
                     const continuum::EquationOfState& gas, double omega) {
    const double threshold = layer_threshold(columns);
    Validity v;
    double all = 0.0, in_layer = 0.0, packed = 0.0;
    for (const continuum::ColumnView& column : columns) {
        for (std::size_t k = 0; k < column.density.size(); ++k) {
            const double n = column.density[k], temperature = column.temperature[k];
            const double nu = continuum::sphere_volume * n;
            all += n;
            if (!(n > threshold)) continue;
            const double knudsen =
                continuum::mean_free_path(n) * temperature_slope(column.temperature, k, spacing) / temperature;
            const double omega_tau = omega / gas.collision_rate(nu, temperature);
            in_layer += n;
            v.knudsen += n * knudsen;
            v.omega_tau += n * omega_tau;
            v.knudsen_largest = std::max(v.knudsen_largest, knudsen);
            v.omega_tau_largest = std::max(v.omega_tau_largest, omega_tau);
            if (nu > packed_volume_fraction) packed += n;
        }
    }
    v.knudsen /= in_layer;
    v.omega_tau /= in_layer;
    v.packed_share = packed / all;
    return v;
}

void add(ValidityOfRun& run, const Validity& state, double share) {
    Validity& m = run.mean;
    m.knudsen += share * state.knudsen;
    m.omega_tau += share * state.omega_tau;
    m.packed_share += share * state.packed_share;
    m.knudsen_largest = std::max(m.knudsen_largest, state.knudsen_largest);
    m.omega_tau_largest = std::max(m.omega_tau_largest, state.omega_tau_largest);
    run.packed_share_largest = std::max(run.packed_share_largest, state.packed_share);
}

ValidityOfRun over_run(std::span<const Validity> states) {
    ValidityOfRun run;
    for (const Validity& state : states) add(run, state, 1.0 / static_cast<double>(states.size()));
    return run;
}

std::vector<std::pair<std::string, double>> named(const ValidityOfRun& run) {
    return {{"knudsen", run.mean.knudsen},           {"knudsen_largest", run.mean.knudsen_largest},
            {"omega_tau", run.mean.omega_tau},       {"omega_tau_largest", run.mean.omega_tau_largest},
            {"packed_share", run.mean.packed_share}, {"packed_share_largest", run.packed_share_largest}};
}

std::vector<std::string> warnings(const ValidityOfRun& run) {
    std::vector<std::string> sentences;
    const Validity& m = run.mean;
    if (m.omega_tau > omega_tau_limit)
        sentences.push_back(fmt::format(
            "omega tau is {:.2g}, above {:g}: the plate moves faster than particles collide, and the continuum may be "
            "far hotter than grains (docs/choosing.md).",
            m.omega_tau, omega_tau_limit));
    if (m.knudsen > knudsen_limit)
        sentences.push_back(fmt::format(
            "The Knudsen number is {:.2g}, above {:g}: T changes much over a mean free path, and the continuum may be "
            "hotter than grains (docs/choosing.md).",
            m.knudsen, knudsen_limit));
    if (m.packed_share > packed_share_limit)
        sentences.push_back(
            fmt::format("{:.2g} % of the mass is above nu = {:g}, more than {:g} %: viscosity and conductivity are not "
                        "known there, and they decide at which acceleration waves begin (docs/choosing.md).",
                        100.0 * m.packed_share, packed_volume_fraction, 100.0 * packed_share_limit));
    return sentences;
}

std::string in_words(const ValidityOfRun& run) {
    const Validity& m = run.mean;
    return fmt::format(
        "Kn {:.2g} in the mean (largest {:.2g}), omega tau {:.2g} ({:.2g}), mass above nu = {:g}: {:.2g} % ({:.2g} %)",
        m.knudsen, m.knudsen_largest, m.omega_tau, m.omega_tau_largest, packed_volume_fraction, 100.0 * m.packed_share,
        100.0 * run.packed_share_largest);
}

}  // namespace shaken::compare
