// SPDX-License-Identifier: MIT
// Statistics of z_cm(ft) on made-up records whose answer is known.
#include "plan/heights.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/support/catch.hpp"

using namespace shaken::plan;

namespace {

/// Height 20, plus what the function adds in each cycle, alike at every phase.
template <class Added>
Heights record(std::size_t cycles, Added added) {
    Heights heights(cycles);
    for (std::size_t c = 0; c < cycles; ++c) heights[c].fill(20.0 + added(c));
    return heights;
}

}  // namespace

TEST_CASE("a start that fades by half a cycle has settled where it is below the tolerance") {
    const Heights heights = record(40, [](std::size_t c) { return 20.0 * std::pow(0.5, c); });
    // Means of two cycles: 0.75 2^-k of the height.
    CHECK(settling_time(heights, 0.01) == 7);
    CHECK(left_of_start(heights, 7, 2)[0] == Approx(0.75 * std::pow(0.5, 7)).epsilon(1e-6));
    // Of a mean over many cycles less is left.
    CHECK(left_of_start(heights, 7, 20)[0] < 0.2 * left_of_start(heights, 7, 2)[0]);
}

TEST_CASE("a layer of two periods is settled, and does not scatter") {
    const Heights heights = record(40, [](std::size_t c) { return c % 2 ? 4.0 : -4.0; });
    CHECK(settling_time(heights, 1e-12) == 0);
    CHECK(spread(heights, 4).value < 1e-12);
}

TEST_CASE("independent cycles have the spread of one, correlated ones more") {
    constexpr std::size_t trials = 41;
    std::vector<double> white, slow;
    std::mt19937 random(1);
    std::normal_distribution<double> normal(0.0, 0.2);
    for (std::size_t k = 0; k < trials; ++k) {
        white.push_back(spread(record(96, [&](std::size_t) { return normal(random); }), 0).value);
        double memory = 0.0;
        slow.push_back(
            spread(record(1600, [&](std::size_t) { return memory = 0.8 * memory + normal(random); }), 0).value);
    }
    std::sort(white.begin(), white.end());
    std::sort(slow.begin(), slow.end());
    // Medians of 41 trials: of the spread of one cycle, known to some 15 per cent from 96 of them;
    // and of a sum over a memory of 0.8, five times as wide, of which blocks that are found long enough miss a part.
    CHECK(white[trials / 2] == Approx(0.01).epsilon(0.1));
    CHECK(white[trials / 10] > 0.007);
    CHECK(white[trials - 1 - trials / 10] < 0.015);
    CHECK(slow[trials / 2] == Approx(0.05).epsilon(0.25));
}

TEST_CASE("a slow drift is told, and is no spread") {
    std::mt19937 random(2);
    std::normal_distribution<double> normal(0.0, 0.2);
    const Heights still = record(96, [&](std::size_t) { return normal(random); });
    const Heights drifting = record(96, [&](std::size_t c) { return normal(random) - 0.01 * static_cast<double>(c); });
    const Spread quiet = spread(still, 0), moving = spread(drifting, 0);
    // One standard deviation of one cycle is 1 per cent.
    CHECK(quiet.value == Approx(0.01).epsilon(3.0 * quiet.uncertainty));
    CHECK(moving.value == Approx(quiet.value).epsilon(0.3));
    CHECK(drift(still, 10, 20, quiet.value) == 0.0);
    // From cycle 20 to cycle 80 in the middle: 0.6 of 19.2; 0.3 per cent of it by chance.
    CHECK(drift(drifting, 10, 20, moving.value) == Approx(0.031).epsilon(0.2));
}
