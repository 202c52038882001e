// SPDX-License-Identifier: MIT
#include "fields/period.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace shaken::fields {

namespace {

constexpr std::size_t fewest = 8;  // three parameters, and five cycles to know the scatter by
// Of (-1)^c z_c, a cycle: below 0.5, ten cycles do not tell; above 0.8, noise of period one is not told from a period.
constexpr double least_memory = 0.5, longest_memory = 0.8;

double sign_of(std::size_t cycle) { return cycle % 2 == 0 ? 1.0 : -1.0; }

double mean_of(std::span<const double> values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

/// What is left of a series above its straight line of least squares.
std::vector<double> straightened(std::vector<double> series) {
    const double mean = mean_of(series), middle = 0.5 * static_cast<double>(series.size() - 1);
    double slope = 0.0, squares = 0.0;
    for (std::size_t c = 0; c < series.size(); ++c) {
        const double x = static_cast<double>(c) - middle;
        slope += x * series[c];
        squares += x * x;
    }
    slope /= squares;
    for (std::size_t c = 0; c < series.size(); ++c) series[c] -= mean + slope * (static_cast<double>(c) - middle);
    return series;
}

/// (-1)^c times what a series is above the line of its fit: gamma in the mean.
std::vector<double> demodulated(std::span<const double> series) {
    std::vector<double> signs(series.size());
    for (std::size_t c = 0; c < signs.size(); ++c) signs[c] = sign_of(c);
    const std::vector<double> s = straightened(signs);
    double product = 0.0, squares = 0.0;
    for (std::size_t c = 0; c < s.size(); ++c) {
        product += s[c] * series[c];
        squares += s[c] * s[c];
    }
    const double gamma = product / squares;
    std::vector<double> rest(series.begin(), series.end());
    for (std::size_t c = 0; c < rest.size(); ++c) rest[c] -= gamma * signs[c];
    rest = straightened(rest);
    for (std::size_t c = 0; c < rest.size(); ++c) rest[c] = gamma + signs[c] * rest[c];
    return rest;
}

/// Sum of (a_c - mean)(a_{c+lag} - mean).
double scatter(std::span<const double> a, double mean, std::size_t lag) {
    double sum = 0.0;
    for (std::size_t c = 0; c + lag < a.size(); ++c) sum += (a[c] - mean) * (a[c + lag] - mean);
    return sum;
}

/// By how much a swing fades a cycle. The correlation found is too low by (1 + 4 rho)/n (Kendall 1954, equation
/// unchecked: the tests hold what comes of it), which is given back; few cycles know it ill, so that some memory is
/// always granted.
double memory_of(std::span<const double> a, double mean) {
    const auto n = static_cast<double>(a.size());
    const double whole = scatter(a, mean, 0);
    if (whole == 0.0) return least_memory;
    return std::clamp((n * scatter(a, mean, 1) / whole + 1.0) / (n - 4.0), least_memory, longest_memory);
}

/// Standard error of the mean of n values a_{c+1} - mean = rho (a_c - mean) + kick, from the scatter of the kicks: a
/// swing that is remembered looks calm for as long as it lasts, but what starts it does not.
double standard_error(std::span<const double> a, double mean, double rho) {
    const auto n = static_cast<double>(a.size());
    double kicks = 0.0;
    for (std::size_t c = 1; c < a.size(); ++c) {
        const double kick = a[c] - mean - rho * (a[c - 1] - mean);
        kicks += kick * kick;
    }
    double sum = 1.0, power = 1.0;
    for (double lag = 1.0; lag < n; ++lag) {
        power *= rho;
        sum += 2.0 * (1.0 - lag / n) * power;
    }
    return std::sqrt(kicks / (n - 4.0) / (1.0 - rho * rho) * sum / n);  // n - 1 kicks, three parameters
}

/// z_cm at a phase, every `stride`-th cycle from the first that was sampled and `skipped` more on.
std::vector<double> series_at(const std::vector<double>& heights, std::int64_t phases, std::int64_t phase,
                              std::size_t skipped = 0, std::size_t stride = 1) {
    std::vector<double> sampled;
    for (auto i = static_cast<std::size_t>(phase); i < heights.size(); i += static_cast<std::size_t>(phases))
        if (!std::isnan(heights[i])) sampled.push_back(heights[i]);
    std::vector<double> series;
    for (std::size_t c = skipped; c < sampled.size(); c += stride) series.push_back(sampled[c]);
    return series;
}

}  // namespace

Alternation alternation_of(std::span<const double> series) {
    if (series.size() < fewest) return {};
    const std::vector<double> a = demodulated(series);
    const double gamma = mean_of(a);
    const std::size_t half = a.size() / 2;
    return {gamma, std::abs(gamma) / standard_error(a, gamma, memory_of(a, gamma)),
            mean_of(std::span(a).last(half)) / mean_of(std::span(a).first(a.size() - half))};
}

bool Alternation::is_significant() const {
    return std::abs(height) > least_alternation && standard_errors > least_standard_errors && lasting > least_lasting;
}

std::optional<int> period_of(const std::vector<double>& heights, std::int64_t phases) {
    bool two = false, four = false;
    std::size_t cycles = 0;
    for (std::int64_t phase = 0; phase < phases; ++phase) {
        const std::vector<double> series = series_at(heights, phases, phase);
        cycles = std::max(cycles, series.size());
        two = two || alternation_of(series).is_significant();
        for (const std::size_t skipped : {0u, 1u})
            four = four || alternation_of(series_at(heights, phases, phase, skipped, 2)).is_significant();
    }
    if (four) return 4;
    if (two) return 2;
    if (cycles < static_cast<std::size_t>(cycles_to_tell)) return std::nullopt;
    return 1;
}

bool odd_cycles_are_higher(const std::vector<double>& heights, std::int64_t phases) {
    double odd_above_even = 0.0;
    for (std::int64_t phase = 0; phase < phases; ++phase) {
        std::array<double, 2> sum{}, count{};
        for (std::size_t i = static_cast<std::size_t>(phase), cycle = 0; i < heights.size();
             i += static_cast<std::size_t>(phases), ++cycle) {
            if (std::isnan(heights[i])) continue;
            sum[cycle % 2] += heights[i];
            count[cycle % 2] += 1.0;
        }
        if (count[0] > 0.0 && count[1] > 0.0) odd_above_even += sum[1] / count[1] - sum[0] / count[0];
    }
    return odd_above_even > 0.0;
}

double opposite_share(const HeightMaps& maps, std::int64_t first_cycle) {
    std::set<double> phases;
    for (std::size_t row = 0; row < maps.rows(); ++row) phases.insert(maps.phase(row));
    std::size_t largest = 0, opposite = 0;
    for (const double phase : phases) {
        std::vector<std::vector<double>> series(maps.grid().size());
        for (const std::size_t row : maps.rows_at(phase, first_cycle)) {
            const std::vector<double> heights = maps.row(row);
            for (std::size_t bin = 0; bin < series.size(); ++bin) series[bin].push_back(heights[bin]);
        }
        std::size_t up = 0, down = 0;
        for (const std::vector<double>& of_bin : series) {
            const Alternation alternation = alternation_of(of_bin);
            if (!alternation.is_significant()) continue;
            ++(alternation.height > 0.0 ? up : down);
        }
        if (up + down <= largest) continue;
        largest = up + down;
        opposite = std::min(up, down);
    }
    if (largest == 0) return 0.0;
    return static_cast<double>(opposite) / static_cast<double>(maps.grid().size());
}

}  // namespace shaken::fields
