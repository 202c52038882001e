// SPDX-License-Identifier: MIT
// Errors of made-up series, whose mean has a variance that is known: rms over many series beside the exact one.
#include "fields/memory.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/normal.hpp"

using namespace shaken;

using fields::mean_with_memory;

namespace {

/// x_i = coefficient x_{i-1} + normal deviate, from its stationary distribution on, plus white noise.
std::vector<double> autoregressive(double coefficient, std::size_t count, std::uint64_t seed, double noise = 0.0) {
    support::Normal normal(seed);
    std::vector<double> x{normal() / std::sqrt(1.0 - coefficient * coefficient)};
    while (x.size() < count) x.push_back(coefficient * x.back() + normal());
    for (double& value : x) value += noise * normal();
    return x;
}

/// Of the mean of `count` such samples: 1/N sum over |k| < N of (1 - |k|/N) gamma_k.
double exact_error(double coefficient, std::size_t count, double noise = 0.0) {
    const auto n = static_cast<double>(count);
    double sum = 1.0;
    for (double k = 1.0; k < n; k += 1.0) sum += 2.0 * (1.0 - k / n) * std::pow(coefficient, k);
    return std::sqrt((sum / (1.0 - coefficient * coefficient) + noise * noise) / n);
}

struct Found {
    double ratio;          // rms of the errors over the exact one
    double scatter;        // of the errors, over the exact one
    double refused;        // share of series that are too short to tell
    double ratio_of_told;  // rms of the errors of the others over the exact one
    double memory = 0.0;   // mean tau
};

Found find(double coefficient, std::size_t count, double noise = 0.0) {
    constexpr std::uint64_t series = 1000;
    double squares = 0.0, sum = 0.0, told = 0.0, of_told = 0.0, memory = 0.0;
    for (std::uint64_t seed = 1; seed <= series; ++seed) {
        const auto found = mean_with_memory(autoregressive(coefficient, count, seed, noise));
        squares += found.error * found.error / series;
        sum += found.error / series;
        memory += found.memory / series;
        if (!found.is_long_enough) continue;
        told += 1.0;
        of_told += found.error * found.error;
    }
    const double exact = exact_error(coefficient, count, noise);
    return {std::sqrt(squares) / exact, std::sqrt(squares - sum * sum) / exact, 1.0 - told / series,
            std::sqrt(of_told / told) / exact, memory};
}

}  // namespace

// Tolerances are statistics unless they say otherwise: a thousand series give the rms of errors that scatter by 30 %
// to 1 %, of those that scatter by half to 2 %.

TEST_CASE("independent samples keep their usual error") {
    for (const std::size_t count : {10, 15, 20, 30, 50, 200, 1000}) {
        CAPTURE(count);
        const Found found = find(0.0, count);
        CHECK(found.ratio == Approx(1.0).margin(0.04));
        CHECK(found.refused < 0.06);
        CHECK(found.scatter < 0.36);  // the usual one: 0.23 of ten samples
    }
    CHECK(find(0.0, 1000).memory == Approx(0.5).margin(0.02));
}

TEST_CASE("the error of samples that remember each other is that of their mean") {
    // Up to the small-sample bias that remains of series of about ten tau.
    for (const auto& [coefficient, count] : {std::pair{0.5, 20}, {0.5, 50}, {0.5, 300}, {0.9, 100}, {0.9, 1000}}) {
        CAPTURE(coefficient, count);
        CHECK(find(coefficient, static_cast<std::size_t>(count)).ratio == Approx(1.0).margin(0.1));
    }
    CHECK(find(0.9, 3000).memory == Approx(9.5).epsilon(0.05));
}

TEST_CASE("samples that alternate have a smaller error") {
    CHECK(find(-0.5, 30).ratio == Approx(1.0).margin(0.1));
    CHECK(find(-0.5, 1000).ratio == Approx(1.0).margin(0.06));
    CHECK(find(-0.5, 90).memory == Approx(1.0 / 6.0).epsilon(0.1));
}

TEST_CASE("memory under noise is found by blocks") {
    CHECK(find(0.9, 1000, 4.6).ratio == Approx(1.0).margin(0.06));  // noise: four times the variance
}

TEST_CASE("a series shorter than its memory is too short to tell") {
    for (const std::size_t count : {20, 30, 50}) {
        CAPTURE(count);
        CHECK(find(0.98, count).refused > 0.9);
        CHECK(find(0.9, count).refused > 0.88);
    }
    CHECK(find(0.9, 100).refused > 0.9);
    CHECK(find(0.9, 1000).refused < 0.02);
    CHECK(find(0.5, 100).refused < 0.04);
    CHECK(find(0.0, 9).refused == 1.0);
    // Most of the memory is in the error nevertheless: the usual one is 0.21 of the exact one.
    CHECK(find(0.9, 30).ratio > 0.7);
}

TEST_CASE("thirty times of memory are enough: the errors that are told are right to a fifth") {
    for (const auto& [coefficient, count] : {std::pair{0.0, 10}, {0.5, 50}, {0.5, 100}, {0.9, 400}, {0.9, 1000}}) {
        CAPTURE(coefficient, count);
        CHECK(find(coefficient, static_cast<std::size_t>(count)).ratio_of_told == Approx(1.0).margin(0.2));
    }
}

TEST_CASE("constant, single and unknown samples") {
    const auto constant = mean_with_memory(std::vector<double>(40, 2.5));
    CHECK(constant.mean == 2.5);
    CHECK(constant.error == 0.0);
    CHECK(constant.memory == 0.5);
    CHECK(constant.is_long_enough);

    const auto one = mean_with_memory(std::vector{1.5});
    CHECK(one.mean == 1.5);
    CHECK(std::isnan(one.error));
    CHECK_FALSE(one.is_long_enough);
    CHECK(std::isnan(mean_with_memory({}).mean));

    std::vector<double> hole = autoregressive(0.0, 40, 1);
    hole[7] = std::numeric_limits<double>::quiet_NaN();
    const auto unknown = mean_with_memory(hole);
    CHECK(std::isnan(unknown.mean));
    CHECK(std::isnan(unknown.error));
    CHECK_FALSE(unknown.is_long_enough);
}

TEST_CASE("two samples have half their difference as error, and the mean is of all samples") {
    const auto two = mean_with_memory(std::vector{1.0, 2.0});
    CHECK(two.error == Approx(0.5));
    CHECK_FALSE(two.is_long_enough);
    std::vector<double> counted(101);
    std::iota(counted.begin(), counted.end(), 0.0);
    CHECK(mean_with_memory(counted).mean == 50.0);
}
