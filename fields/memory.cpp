// SPDX-License-Identifier: MIT
#include "fields/memory.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace shaken::fields {

namespace {

constexpr std::size_t most_blocks = 100;
// Found on made-up series (tests/fields/memory_tests.cpp): of those of ten tau nine in ten do not pass.
constexpr double times_long_enough = 30.0;
constexpr double fewest = 10.0;                // samples: the error of so many scatters by a quarter
constexpr double closest_to_unit_root = 0.98;  // of partial autocorrelations and of their sum: keeps errors finite

double mean_of(std::span<const double> x) {
    return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

/// Means of blocks of equal length; the samples after the last whole block are left out.
std::vector<double> gathered(std::span<const double> samples) {
    const std::size_t length = (samples.size() + most_blocks - 1) / most_blocks;
    std::vector<double> blocks;
    for (std::size_t from = 0; from + length <= samples.size(); from += length)
        blocks.push_back(mean_of(samples.subspan(from, length)));
    return blocks;
}

/// c_k = 1/N sum (x_i - m)(x_{i+k} - m) for lags 0 to `lags`.
std::vector<double> autocovariances(std::span<const double> x, std::size_t lags) {
    const double mean = mean_of(x);
    std::vector<double> c(lags + 1, 0.0);
    for (std::size_t k = 0; k <= lags; ++k)
        for (std::size_t i = 0; i + k < x.size(); ++i)
            c[k] += (x[i] - mean) * (x[i + k] - mean) / static_cast<double>(x.size());
    return c;
}

/// x_i = sum_j coefficients_j x_{i-j} + noise.
struct Autoregression {
    std::vector<double> coefficients;
    double noise = 0.0;  // variance

    std::size_t order() const { return coefficients.size(); }
    /// Sum of the autocovariances over all lags: N times the variance of a long mean.
    double sum_of_autocovariances() const {
        const double sum = std::accumulate(coefficients.begin(), coefficients.end(), 0.0);
        return noise / std::pow(1.0 - std::min(sum, closest_to_unit_root), 2);
    }
    /// The next order, by the recursion of Levinson and Durbin. c_0 > 0.
    void raise(const std::vector<double>& c) {
        const std::size_t p = order() + 1;
        double partial = c[p];
        for (std::size_t j = 1; j < p; ++j) partial -= coefficients[j - 1] * c[p - j];
        partial = std::clamp(partial / noise, -closest_to_unit_root, closest_to_unit_root);
        std::vector<double> next(coefficients);
        for (std::size_t j = 1; j < p; ++j) next[j - 1] -= partial * coefficients[p - j - 1];
        next.push_back(partial);
        coefficients = std::move(next);
        noise *= 1.0 - partial * partial;
    }
};

Autoregression fitted(const std::vector<double>& c, std::size_t order) {
    Autoregression model{{}, c[0]};
    while (model.order() < order) model.raise(c);
    return model;
}

/// The order that loses least by the corrected criterion of Akaike.
std::size_t wanted_order(const std::vector<double>& c, double count) {
    Autoregression model{{}, c[0]};
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t order = 0;; ++order) {
        const auto p = static_cast<double>(order);
        const double loss = count * std::log(model.noise) + 2.0 * p * count / (count - p - 2.0);
        if (loss < least) {
            least = loss;
            best = order;
        }
        if (order + 1 == c.size()) return best;
        model.raise(c);
    }
}

/// Deviations are from the mean of the samples themselves, which takes the variance of that mean from every c_k: it is
/// given back once the memory is known, and the memory found anew.
double sum_of_autocovariances(std::span<const double> blocks) {
    const auto count = static_cast<double>(blocks.size());
    const std::size_t lags = std::min(static_cast<std::size_t>(2.0 * std::cbrt(count)), blocks.size() / 5);
    std::vector<double> c = autocovariances(blocks, lags);
    if (!(c[0] > 0.0)) return 0.0;
    const std::size_t order = wanted_order(c, count);
    const double free = count - static_cast<double>(order) - 1.0;
    const double first = count / free * fitted(c, order).sum_of_autocovariances();
    if (order == 0) return first;
    const double taken = std::min(first / count, 3.0 * c[0]);
    for (std::size_t k = 0; k < c.size(); ++k) c[k] += (1.0 - static_cast<double>(k) / count) * taken;
    return fitted(c, order).sum_of_autocovariances();
}

}  // namespace

MeanWithMemory mean_with_memory(std::span<const double> samples) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    constexpr double of_independent = 0.5;
    if (samples.empty()) return {unknown, unknown, unknown, false};
    const double mean = mean_of(samples);
    if (samples.size() < 2 || !std::isfinite(mean)) return {mean, unknown, unknown, false};
    const std::vector<double> blocks = gathered(samples);
    const auto count = static_cast<double>(samples.size()), block_count = static_cast<double>(blocks.size());
    const double squared_error = sum_of_autocovariances(blocks) / block_count;
    const double variance = autocovariances(samples, 0)[0] * count / (count - 1.0);
    const double variance_of_blocks = autocovariances(blocks, 0)[0] * block_count / (block_count - 1.0);
    const auto time = [&](double n, double v) { return v > 0.0 ? 0.5 * n * squared_error / v : of_independent; };
    const double of_blocks = time(block_count, variance_of_blocks);
    const bool have_memory = of_blocks > 1.001 * of_independent;  // beyond round-off: of blocks without it tau is 1/2
    const double needed = have_memory ? std::max(fewest, times_long_enough * of_blocks) : fewest;
    return {mean, std::sqrt(squared_error), time(count, variance), block_count >= needed};
}

}  // namespace shaken::fields
