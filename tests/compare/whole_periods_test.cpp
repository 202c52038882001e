// SPDX-License-Identifier: MIT
// What alternates from cycle to cycle comes back after two: averages over any window must not take what lasts for it.
#include <cmath>
#include <numbers>

#include "compare/patterns/pattern_summary.hpp"
#include "scene/random_stream.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;
using compare::Amplitude;

namespace {

constexpr double round_off = 1e-14;  // of sums of some ten numbers of order one

/// coherent_part of so many cycles from one on.
template <class Wave>
compare::CoherentPart coherent(std::int64_t first, std::size_t count, const Wave& wave) {
    std::vector<std::int64_t> cycles;
    std::vector<Amplitude> amplitudes;
    for (std::size_t i = 0; i < count; ++i) {
        cycles.push_back(first + static_cast<std::int64_t>(i));
        amplitudes.push_back(wave(cycles.back()));
    }
    return compare::coherent_part(cycles, amplitudes);
}

double sign(std::int64_t cycle) { return cycle % 2 == 0 ? 1.0 : -1.0; }

}  // namespace

TEST_CASE("a wave that stands still does not alternate, however many cycles are seen") {
    const std::int64_t first = GENERATE(7, 8);
    for (std::size_t count = 2; count <= 21; ++count) {
        INFO(count << " cycles from " << first);
        const auto part = coherent(first, count, [](std::int64_t) { return Amplitude(0.5, -0.3); });
        CHECK(std::abs(part.mean) < round_off);
        CHECK(std::isnan(part.error) == (count < 4));
        if (count >= 4) CHECK(part.error < round_off);
    }
    CHECK(std::isnan(coherent(first, 1, [](std::int64_t) { return Amplitude(0.5, -0.3); }).mean.real()));
}

TEST_CASE("a wave that alternates is found whole, however many cycles are seen") {
    const std::int64_t first = GENERATE(7, 8);
    for (std::size_t count = 2; count <= 21; ++count) {
        INFO(count << " cycles from " << first);
        const auto part = coherent(first, count, [](std::int64_t c) { return sign(c) * Amplitude(0.5, -0.3); });
        CHECK(std::abs(part.mean - Amplitude(0.5, -0.3)) < round_off);
        if (count >= 4) CHECK(part.error < round_off);
    }
}

TEST_CASE("what a drifting wave leaves in the alternating part is covered by its error") {
    const std::int64_t first = GENERATE(7, 8);
    for (std::size_t count = 4; count <= 21; ++count) {
        INFO(count << " cycles from " << first);
        const auto part =
            coherent(first, count, [](std::int64_t c) { return Amplitude(0.2, 0.1) * static_cast<double>(c); });
        CHECK(std::abs(part.mean) > 0.1);  // half the change a cycle, 0.22
        CHECK(std::abs(part.mean) <= part.error * (1.0 + 1e-12));
    }
}

TEST_CASE("noise alone has an alternating part of the size of its error") {
    scene::RandomStream random(3);
    for (const std::size_t count : {4, 5, 6, 9, 40}) {
        double found = 0.0, told = 0.0;
        constexpr int trials = 4000;
        for (int trial = 0; trial < trials; ++trial) {
            const auto part =
                coherent(5, count, [&](std::int64_t) { return Amplitude(random.normal(), random.normal()); });
            found += std::norm(part.mean) / trials;
            told += part.error * part.error / trials;
        }
        INFO(count << " cycles");
        const double whole = static_cast<double>(count / 2 * 2);
        CHECK(found == Approx(2.0 / whole).epsilon(0.08));  // statistics: 1/sqrt(4000) = 1.6 %, five of it
        CHECK(told > 0.92 * found);                         // the error is never less, but for statistics
        CHECK(told < 1.25 * found);  // of two blocks the larger of two estimates is some 10 % more
    }
}

TEST_CASE(
    "<psi^2> of a wave that stands still under one that alternates is the same over any window, without scatter") {
    // |0.4 + 0.7|^2 and |0.4 - 0.7|^2 by turns: their mean is 0.4^2 + 0.7^2.
    fields::HeightMaps maps({10, 4, 20.0, 8.0});
    for (std::int64_t c = 0; c < 50; ++c) {
        maps.begin(c, 0.25);
        for (std::int64_t iy = 0; iy < 4; ++iy)
            for (std::int64_t ix = 0; ix < 10; ++ix) {
                const double x = 2.0 * static_cast<double>(ix) + 1.0;
                maps.add_point(x, 2.0 * static_cast<double>(iy) + 1.0, 1.0,
                               6.0 + (0.4 + 0.7 * sign(c)) * std::cos(2.0 * std::numbers::pi * x / 20.0));
            }
        maps.end();
    }
    for (std::int64_t cycles = 2; cycles <= 45; ++cycles) {
        const auto summary = compare::summarise_pattern(maps, {0.25, 3, cycles});
        INFO(cycles << " cycles");
        CHECK(summary.maps == cycles / 2 * 2);
        CHECK(summary.window.cycles == summary.maps);
        CHECK(summary.window.first == 3 + cycles % 2);
        CHECK(summary.mean_square.value == Approx(0.5 * (0.16 + 0.49)).epsilon(1e-12));  // round-off
        if (cycles < 4) continue;
        CHECK(summary.mean_square.error < 1e-12);
        CHECK(summary.coherent_share == Approx(0.49 / 0.65).epsilon(1e-12));
        for (const compare::PatternBlock& block : summary.blocks)
            CHECK(block.mean_square == Approx(summary.mean_square.value).epsilon(1e-12));
    }
    CHECK(compare::summarise_pattern(maps, {0.25, 4, 1}).mean_square.value == Approx(0.5 * 1.21).epsilon(1e-12));
}

TEST_CASE("the two parts of a wave's covariance do not mix, whatever the number of cycles") {
    compare::MapTransform transform({10, 4, 20.0, 8.0});
    const std::vector<compare::PlaneWave> one(transform.waves().begin(), transform.waves().begin() + 1);
    for (const int cycles : {40, 47, 57, 63, 200}) {  // two, three and eight blocks, whose length is odd where it may
        std::vector<std::vector<Amplitude>> series;
        for (int c = 0; c < cycles; ++c) series.push_back({Amplitude(0.4 + 0.7 * sign(c), 0.0)});
        const compare::Fluctuation found = compare::fluctuations(one, series, 1).front();
        INFO(cycles << " cycles");
        CHECK(found.power == Approx(one[0].share * 0.65).epsilon(1e-12));  // round-off
        CHECK(found.decays.persistent ==
              Approx(one[0].share * 0.16).epsilon(1e-3));  // as loosely as its factor is held
        CHECK(found.decays.alternating == Approx(one[0].share * 0.49).epsilon(1e-3));
    }
}
