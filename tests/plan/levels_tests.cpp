// SPDX-License-Identifier: MIT
// Errors of made-up grids that follow a known power law exactly.
#include "plan/levels.hpp"

#include <cmath>

#include "tests/support/catch.hpp"

using namespace shaken::plan;

namespace {

/// Of the answer, by phase and of either sign; its root mean square is 1e-6 sqrt(38.5).
double part(std::size_t phase) { return 1e-6 * (phase % 2 == 0 ? 1.0 : -1.0) * static_cast<double>(phase % 10 + 1); }
const double size = 1e-6 * std::sqrt(38.5);

/// Four grids of 1.6 to 0.2: an error of part dz^order, seconds as 1/dz^2, steps as 1/dz.
std::vector<Level> power_law(double order) {
    std::vector<Level> levels;
    for (const double dz : {1.6, 0.8, 0.4, 0.2}) {
        Level level;
        level.spacing = dz;
        level.seconds = 3.0 / (dz * dz);
        level.steps = 5.0 / dz;
        for (std::size_t p = 0; p < phases; ++p)
            level.profile[p] = (10.0 + static_cast<double>(p)) * (1.0 + part(p) * std::pow(dz, order));
        levels.push_back(level);
    }
    tell_errors(levels, order);
    return levels;
}

}  // namespace

TEST_CASE("errors of a known power law are found on every grid, with their signs") {
    const double order = GENERATE(1.0, 1.5, 2.0);
    for (const Level& level : power_law(order)) {
        INFO("order " << order << ", spacing " << level.spacing);
        const double scale = std::pow(level.spacing, order);
        // Truncation: shares are of heights that are themselves off by 1e-5; and round-off of 1e-16 over 1e-6.
        CHECK(level.error == Approx(size * scale).epsilon(1e-4));
        for (std::size_t p = 0; p < phases; ++p)
            CHECK(level.deviation[p] == Approx(part(p) * scale).epsilon(1e-4).margin(1e-14));
    }
}

TEST_CASE("what is foretold between the grids and beyond the finest is the power law") {
    const double order = GENERATE(1.0, 1.5, 2.0);
    const std::vector<Level> levels = power_law(order);
    for (const double dz : {1.6, 1.2, 0.8, 0.5, 0.2, 0.15, 0.1, 0.05}) {
        INFO("order " << order << ", spacing " << dz);
        const double error = interpolate(levels, dz, &Level::error, order);
        CHECK(error == Approx(size * std::pow(dz, order)).epsilon(1e-4));  // truncation, as above
        CHECK(interpolate(levels, dz, &Level::seconds, -2.0) == Approx(3.0 / (dz * dz)).epsilon(1e-12));  // round-off
        CHECK(interpolate(levels, dz, &Level::steps, -1.0) == Approx(5.0 / dz).epsilon(1e-12));
        const Profile there = deviation_at(levels, dz, error);
        for (std::size_t p = 0; p < phases; ++p)
            CHECK(there[p] == Approx(part(p) * std::pow(dz, order)).epsilon(1e-4).margin(1e-14));
    }
}

TEST_CASE("of a single grid no error is known") {
    std::vector<Level> one{Level{.spacing = 0.4}};
    one[0].profile.fill(5.0);
    tell_errors(one, 2.0);
    CHECK(one[0].error == 0.0);
}
