// SPDX-License-Identifier: MIT
// Made-up runs of which every rate is known: tolerances are round-off, or the one interval by which a block may be
// longer.
#include "run/gas_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

constexpr double particles = 50.0, interval = 0.5, collided = 1.75, pressure = 2.5;

/// T = 1/(1 + cooling t)^2, which Haff's law is; collisions of a particle grow by `collided` times sqrt(T) dt, Z is
/// `pressure`, a2 the number of the row.
fields::TimeSeries gas(double cooling, int rows) {
    fields::TimeSeries series({"temperature", "fourth_cumulant", "virial", "pair_collisions"});
    for (int row = 0; row < rows; ++row) {
        const double time = interval * row, root = 1.0 + cooling * time;
        // Integrals of sqrt(T) and T; the total momentum is zero.
        const double speed = cooling > 0.0 ? std::log(root) / cooling : time, heat = time / root;
        const double scale = particles / (particles - 1.0);
        series.add(row, time,
                   std::array{1.0 / (root * root), 1.0 * row, (pressure - 1.0) * 3.0 * particles * heat * scale,
                              0.5 * collided * particles * speed * std::sqrt(scale)});
    }
    return series;
}

double mean(const std::vector<double>& x) {
    return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

}  // namespace

TEST_CASE("blocks of a gas that cools by Haff's law hold its pressure, collision rate and cooling") {
    const double cooling = GENERATE(0.0, 0.1, 2.0);
    const int rows = GENERATE(2, 60, 101, 1001);
    CAPTURE(cooling, rows);
    const run::GasBlocks blocks = run::gas_blocks(gas(cooling, rows), 0, particles);
    for (std::size_t b = 0; b < blocks.rate.size(); ++b) {
        CHECK(blocks.compressibility[b] == Approx(pressure).epsilon(1e-9));
        CHECK(blocks.rate[b] == Approx(collided).epsilon(1e-9));
        CHECK(blocks.cooling[b] == Approx(cooling).margin(1e-9));
    }
    REQUIRE(blocks.rate.size() >= 1);
    CHECK(blocks.rate.size() <= 100);
}

TEST_CASE("blocks of a gas that does not cool are of equal time, the first rows left out") {
    const run::GasBlocks blocks = run::gas_blocks(gas(0.0, 1021), 20, particles);
    REQUIRE(blocks.cumulant.size() == 100);
    for (std::size_t b = 0; b < 100; ++b)
        CHECK(blocks.cumulant[b] == Approx(20.0 + 10.0 * static_cast<double>(b) + 5.5));
    CHECK(run::gas_blocks(gas(0.0, 41), 0, particles).cumulant.size() == 40);
    CHECK(run::gas_blocks(gas(0.0, 21), 20, particles).cumulant.empty());
}

TEST_CASE("late blocks of a gas that cools are longer: a particle is due for as many collisions") {
    // sqrt(T) falls to 1/51: a block has ln(51)/100 of the integral, or an interval where that is more.
    const run::GasBlocks blocks = run::gas_blocks(gas(0.1, 1001), 0, particles);
    std::vector<double> rows;  // the last one of each block: mean a2 is its middle
    double before = 0.0;
    for (const double middle : blocks.cumulant) {
        rows.push_back(2.0 * middle - before - 1.0);
        before = rows.back();
    }
    REQUIRE(rows.back() == Approx(1000.0));
    const auto due = [&](std::size_t b) {
        return std::log((1.0 + 0.05 * rows[b]) / (1.0 + 0.05 * (b > 0 ? rows[b - 1] : 0.0)));
    };
    const double share = std::log(51.0) / 100.0;
    for (std::size_t b = 0; b < rows.size(); ++b) {
        const double one_interval = 0.05 / (1.0 + 0.05 * (b > 0 ? rows[b - 1] : 0.0));
        CAPTURE(b);
        CHECK(due(b) > (1.0 - 1e-6) * std::min(share, one_interval) - (b + 1 == rows.size() ? 0.5 * share : 0.0));
        CHECK(due(b) < share + one_interval + (b + 1 == rows.size() ? 0.5 * share : 0.0));
    }
    CHECK(mean(blocks.cumulant) < 400.0);  // not the 500.5 of blocks of equal time
}
