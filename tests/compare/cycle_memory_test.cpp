// SPDX-License-Identifier: MIT
#include "compare/cycle_memory.hpp"

#include <cmath>

#include "compare/analysis.hpp"
#include "synthetic.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

/// A layer whose centre of mass keeps a part of its deviation from cycle to cycle: x_c = kept x_{c-1} + noise of 1.
fields::PhaseMoments remembering_run(double kept, std::int64_t cycles, std::int64_t blocks, std::uint64_t seed) {
    synthetic::Normal normal(seed);
    fields::PhaseMoments moments(fields::Deposits::cells, 4, {0.0, 0.5, 20}, 4.0, cycles, blocks);
    std::vector<double> height(4);
    for (double& h : height) h = normal() / std::sqrt(1.0 - kept * kept);
    for (std::int64_t cycle = 0; cycle < cycles; ++cycle)
        for (std::int64_t phase = 0; phase < 4; ++phase) {
            double& h = height[static_cast<std::size_t>(phase)];
            h = kept * h + normal();
            moments.begin_sample(cycle, phase);
            moments.add_slab(1.0, 9.0, 0.5, {0.0, 0.0, 0.0}, 1.0);
            moments.set_centre_of_mass(20.0 + h);
        }
    return moments;
}

compare::CycleMemory memory_of(double kept, std::int64_t cycles, std::int64_t blocks, std::uint64_t seed = 1) {
    return compare::cycle_memory(remembering_run(kept, cycles, blocks, seed), {});
}

}  // namespace

TEST_CASE("errors from blocks are short by the memory that leaves them") {
    CHECK(compare::error_over_that_of_blocks(0.5, 6.0) == 1.0);
    CHECK(compare::error_over_that_of_blocks(0.2, 6.0) == 1.0);
    // Blocks of one: sqrt(2 tau). Of many tau: 1 (truncation, tau / length).
    CHECK(compare::error_over_that_of_blocks(4.5, 1.0) == Approx(3.0));
    CHECK(compare::error_over_that_of_blocks(4.5, 2000.0) == Approx(1.0).epsilon(0.003));
}

TEST_CASE("the memory of a layer is found from its cycles, and the error of its mean is right in short blocks") {
    // Statistics: four phases of 400 cycles, 44 times the memory each.
    CHECK(memory_of(0.8, 400, 10).cycles == Approx(4.5).epsilon(0.35));
    CHECK(memory_of(0.0, 400, 10).cycles == Approx(0.5).epsilon(0.25));
    CHECK(memory_of(0.0, 400, 10).factor < 1.05);

    // Rms over runs of the error of the mean height: blocks of two cycles, of which ten are forgotten.
    constexpr std::uint64_t runs = 100;
    double said = 0.0;
    for (std::uint64_t seed = 1; seed <= runs; ++seed) {
        const auto measured =
            compare::measure(remembering_run(0.8, 200, 100, seed), {5.0, 0.1}, synthetic::ideal_gas());
        const auto height = [](const compare::Analysis& a) { return a.centre_of_mass[1]; };
        said += std::pow(measured.estimate(height).error, 2) / runs;
    }
    // 1/((1 - 0.8)^2 200) less the ends of the run (1 %); statistics of the memory of 200 cycles: 25 %/sqrt(100).
    CHECK(std::sqrt(said) == Approx(std::sqrt(25.0 / 200.0)).epsilon(0.12));
}

TEST_CASE("too few cycles to tell are said") {
    CHECK(memory_of(0.0, 150, 10).is_long_enough);
    CHECK_FALSE(compare::note_of(memory_of(0.0, 150, 10), 150));
    CHECK_FALSE(memory_of(0.0, 5, 5).is_long_enough);
    CHECK_FALSE(memory_of(0.9, 40, 10).is_long_enough);
    CHECK_THAT(compare::note_of(memory_of(0.0, 5, 5), 5).value(), Contains("averages 5 cycles: too few"));
    CHECK(std::isnan(memory_of(0.0, 1, 1).cycles));
}

TEST_CASE("cycles that alternate are of two flows, each with its own memory") {
    fields::PhaseMoments moments(fields::Deposits::cells, 2, {0.0, 0.5, 20}, 4.0, 200, 10);
    synthetic::Normal normal(3);
    for (std::int64_t cycle = 0; cycle < 200; ++cycle)
        for (std::int64_t phase = 0; phase < 2; ++phase) {
            moments.begin_sample(cycle, phase);
            moments.add_slab(1.0, 9.0, 0.5, {0.0, 0.0, 0.0}, 1.0);
            moments.set_centre_of_mass(20.0 + (cycle % 2 == 0 ? 3.0 : -3.0) + normal());
        }
    CHECK(moments.centres_of_mass(1, fields::Flow::second).size() == 100);
    CHECK(moments.centres_of_mass(1).size() == 200);
    const compare::CycleMemory apart = compare::cycle_memory(moments, {2, true, 2});
    CHECK(apart.cycles == Approx(0.5).epsilon(0.5));  // statistics: four series, 35 % each, three of these
    CHECK(compare::cycle_memory(moments, {2, false, 1}).factor == 1.0);
}
