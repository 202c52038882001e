// SPDX-License-Identifier: MIT
// Statistics of z_cm(ft) on made-up records whose answer is known.
#include "plan/heights.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

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
    std::mt19937 random(1);
    std::normal_distribution<double> normal(0.0, 0.2);
    // 1600 cycles in eight blocks: the estimate itself is known to 33 per cent.
    const Heights white = record(1600, [&](std::size_t) { return normal(random); });
    const Spread found = spread(white, 0);
    CHECK(found.blocks == 16 / 2);
    CHECK(found.value == Approx(0.01).epsilon(3.0 * found.uncertainty));
    double memory = 0.0;
    const Heights slow = record(1600, [&](std::size_t) { return memory = 0.8 * memory + normal(random); });
    // A sum over a memory of 0.8 is five times as wide.
    CHECK(spread(slow, 0).value == Approx(0.05).epsilon(3.0 * found.uncertainty));
}

TEST_CASE("a slow drift is told, and is no spread") {
    std::mt19937 random(2);
    std::normal_distribution<double> normal(0.0, 0.2);
    const Heights still = record(96, [&](std::size_t) { return normal(random); });
    const Heights drifting = record(96, [&](std::size_t c) { return normal(random) - 0.02 * static_cast<double>(c); });
    const Spread quiet = spread(still, 0), moving = spread(drifting, 0);
    // One standard deviation of one cycle is 1 per cent; eight blocks give it to 33 per cent.
    CHECK(quiet.value == Approx(0.01).epsilon(3.0 * quiet.uncertainty));
    CHECK(moving.value == Approx(0.01).epsilon(3.0 * moving.uncertainty));
    CHECK(drift(still, 10, 20, quiet.value) == 0.0);
    // From cycle 20 to cycle 80 in the middle: 1.2 of 18.4.
    CHECK(drift(drifting, 10, 20, moving.value) == Approx(0.065).epsilon(0.1));
}
