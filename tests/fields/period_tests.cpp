// SPDX-License-Identifier: MIT
#include "fields/period.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "tests/support/catch.hpp"

using namespace shaken::fields;

namespace {

constexpr std::int64_t phases = 4;

/// z_cm(cycle, phase): a height of the cycle, higher by `lift` at each later phase.
std::vector<double> heights(std::int64_t cycles, const std::function<double(std::int64_t)>& of_cycle,
                            double lift = 1.0) {
    std::vector<double> z;
    for (std::int64_t cycle = 0; cycle < cycles; ++cycle) {
        const double height = of_cycle(cycle);
        for (std::int64_t phase = 0; phase < phases; ++phase) z.push_back(height + lift * static_cast<double>(phase));
    }
    return z;
}

double sign(std::int64_t cycle) { return cycle % 2 == 0 ? 1.0 : -1.0; }

/// Noise whose swings fade by rho a cycle (negative: they alternate), of unit kicks.
class Noise {
  public:
    explicit Noise(std::uint64_t seed, double rho = 0.0) : engine_(seed), rho_(rho) {
        last_ = kick() / std::sqrt(1.0 - rho * rho);
    }
    double operator()() { return last_ = rho_ * last_ + kick(); }

  private:
    double kick() {  // by hand, so that it is the same with every library
        const auto uniform = [&] { return std::ldexp(static_cast<double>((engine_() >> 11) + 1), -53); };
        const double radius = std::sqrt(-2.0 * std::log(uniform()));
        return radius * std::cos(6.283185307179586 * uniform());
    }
    std::mt19937_64 engine_;
    double rho_, last_;
};

int doubled(std::int64_t cycles, double rho, double kicks) {
    int found = 0;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        Noise noise(seed, rho);
        if (period_of(heights(cycles, [&](auto) { return 10.0 + kicks * noise(); }), phases).value_or(1) > 1) ++found;
    }
    return found;
}

}  // namespace

TEST_CASE("noise of period one is not taken for a longer period") {
    const std::int64_t cycles = GENERATE(8, 11, 40);
    CAPTURE(cycles);
    CHECK(doubled(cycles, 0.0, 3.0) == 0);
}

TEST_CASE("swings that alternate and are forgotten are no period of two") {
    // Swings of a small box near doubling: kicks of 0.1, root mean square 0.17, a third of the least height.
    CHECK(doubled(20, -0.8, 0.1) == 0);
    CHECK(doubled(50, -0.8, 0.1) == 0);
    // Of any size: statistics, three standard errors above 1.1 %, 0.7 % and 0.1 % of a thousand series.
    CHECK(doubled(10, -0.8, 10.0) < 22);
    CHECK(doubled(20, -0.8, 10.0) < 15);
    CHECK(doubled(100, -0.8, 10.0) < 4);
}

TEST_CASE("a layer that alternates has a period of two, also over an odd number of cycles and while it drifts") {
    const std::int64_t cycles = GENERATE(10, 11, 50, 51);
    const double drift = GENERATE(0.0, 0.1);
    int found = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        Noise noise(seed);
        const auto z = heights(cycles, [&](std::int64_t c) {
            return 15.0 + 6.0 * sign(c) + drift * static_cast<double>(c) + 0.4 * noise();
        });
        found += period_of(z, phases) == 2 ? 1 : 0;
    }
    CHECK(found == 100);  // fifteen times the scatter of a cycle
    CHECK(alternation_of(std::vector<double>(11, 12.0)).height == Approx(0.0).margin(1e-12));  // round-off
}

TEST_CASE("the alternation is the coefficient of its fit") {
    std::vector<double> series;
    for (std::int64_t c = 0; c < 13; ++c) series.push_back(7.0 + 0.3 * static_cast<double>(c) - 1.25 * sign(c));
    CHECK(alternation_of(series).height == Approx(-1.25).epsilon(1e-12));  // round-off
    CHECK(alternation_of(series).lasting == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("an alternation that fades is a layer that settles, one that stays is a period of two") {
    const auto fading = [](double rho) {
        return heights(20, [rho](std::int64_t c) { return 12.0 + 4.0 * std::pow(-rho, static_cast<double>(c)); });
    };
    CHECK(period_of(fading(0.8), phases) == 1);
    CHECK(period_of(fading(0.9), phases) == 1);
    CHECK(period_of(fading(1.0), phases) == 2);
    const auto below_the_limit = heights(20, [](std::int64_t c) { return 12.0 + 0.49 * sign(c); });
    CHECK(period_of(below_the_limit, phases) == 1);
}

TEST_CASE("four cycles that differ are a period of four") {
    Noise noise(3);
    const auto z = heights(40, [&](std::int64_t c) {
        const double second = c % 4 < 2 ? 1.5 : -1.5;
        return 15.0 + 5.0 * sign(c) + (c % 2 == 0 ? second : 0.0) + 0.1 * noise();
    });
    CHECK(period_of(z, phases) == 4);
}

TEST_CASE("few cycles do not tell, and what was not sampled is left out") {
    CHECK_FALSE(period_of(heights(7, [](std::int64_t c) { return 15.0 + 5.0 * sign(c); }), phases));
    CHECK_FALSE(period_of(heights(9, [](std::int64_t) { return 15.0; }), phases));
    CHECK(period_of(heights(10, [](std::int64_t) { return 15.0; }), phases) == 1);
    CHECK_FALSE(period_of(std::vector<double>(40, std::numeric_limits<double>::quiet_NaN()), phases));
    auto begun_within_a_cycle = heights(12, [](std::int64_t c) { return 15.0 + 5.0 * sign(c); });
    for (std::size_t i = 0; i < 2; ++i) begun_within_a_cycle[i] = std::numeric_limits<double>::quiet_NaN();
    CHECK(period_of(begun_within_a_cycle, phases) == 2);
}

TEST_CASE("the cycle with the higher mean comes first") {
    const auto even = heights(9, [](std::int64_t c) { return 15.0 + 2.0 * sign(c); });
    const auto odd = heights(9, [](std::int64_t c) { return 15.0 - 2.0 * sign(c); });
    CHECK_FALSE(odd_cycles_are_higher(even, phases));
    CHECK(odd_cycles_are_higher(odd, phases));
    // A first cycle cut at half, of which the higher phases are there: each phase is held against itself.
    auto cut = even;
    for (std::size_t i = 0; i < 2; ++i) cut[i] = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(odd_cycles_are_higher(cut, phases));
}

TEST_CASE("the share of the area that alternates against the rest is that of its bins") {
    HeightMaps maps({5, 4, 10.0, 8.0});
    for (std::int64_t cycle = 0; cycle < 14; ++cycle) {
        maps.begin(cycle, 0.25);
        for (int x = 0; x < 5; ++x) {
            for (int y = 0; y < 4; ++y) {
                const bool is_opposite = x == 0 && y < 3, is_settling = cycle < 4;
                maps.add_point(
                    2.0 * x + 1.0, 2.0 * y + 1.0, 1.0,
                    12.0 + (is_settling ? 30.0 : 2.0) * sign(cycle) * (is_opposite != is_settling ? -1.0 : 1.0));
            }
        }
        maps.end();
    }
    CHECK(opposite_share(maps, 4) == Approx(3.0 / 20.0));
    CHECK(opposite_share(HeightMaps{}, 0) == 0.0);
}
