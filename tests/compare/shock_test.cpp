// SPDX-License-Identifier: MIT
#include "compare/shock.hpp"

#include <cmath>

#include "synthetic.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

std::optional<compare::Shock> find(const fields::Profile& profile, const compare::ShockCriteria& criteria = {}) {
    const compare::Medium medium = synthetic::ideal_gas();
    const auto layer = compare::find_layer(profile);
    REQUIRE(layer);
    return compare::find_shock(profile, *layer, compare::mach_numbers(profile, medium), medium, criteria);
}

}  // namespace

TEST_CASE("a layer in which no bin has a temperature has no shock") {
    fields::Profile profile = synthetic::Front{}.profile({0.0, 0.5, 80});
    for (double& t : profile.temperature) t = std::nan("");
    CHECK_FALSE(find(profile));
}

TEST_CASE("a front is found at its steepest fall, closer than a tenth of a bin") {
    const double location = GENERATE(4.0, 5.13, 6.28, 7.4, 9.99);
    const double half_width = GENERATE(0.7, 1.2);
    const synthetic::Front front{.location = location, .half_width = half_width};
    const auto shock = find(front.profile({0.0, 0.5, 80}));
    REQUIRE(shock);
    INFO("location " << location << ", half width " << half_width);
    // Truncation: the parabola through slopes half a sigma apart misses a sech^2 of half width 0.7 by up to 0.04.
    CHECK(shock->location == Approx(front.exact_location()).margin(0.05));
    // The foot and the top of a tanh are flat: bins of 0.5 place them within half a bin.
    CHECK(shock->top == Approx(front.exact_top()).margin(0.25));
    CHECK(shock->foot == Approx(front.exact_foot()).margin(0.25));
    CHECK(shock->inside_layer);
    CHECK(shock->mach_above > 1.0);
    CHECK(shock->mach_below < 1.0);
}

TEST_CASE("the place and the slope of a front converge as bins and window shrink") {
    const synthetic::Front front{.location = 6.27, .half_width = 0.7};
    const auto shock = [&](double width) {
        const auto found =
            find(front.profile({0.0, width, static_cast<std::int64_t>(40.0 / width)}), {.window = width});
        REQUIRE(found);
        return *found;
    };
    const auto error = [&](double width) { return std::abs(shock(width).location - front.exact_location()); };
    // Truncation is at least second order in the bin; 2e-4 is the step of the brute-force reference.
    CHECK(error(0.125) < error(0.5) / 16.0 + 2e-4);
    // Truncation of the slope, second order: some (0.125/0.7)^2 of it.
    const double z = front.exact_location(), h = 1e-3;
    const double slope = (front.temperature(z - h) - front.temperature(z + h)) / (2.0 * h);
    CHECK(shock(0.125).steepest_slope == Approx(slope).epsilon(0.02));
    CHECK(shock(0.125).slope_width() < shock(0.125).width());
}

TEST_CASE("a hot thin gas between the plate and the falling layer is no shock, unless compression is not asked for") {
    fields::Profile profile = synthetic::Front{}.profile({0.0, 0.5, 80});
    for (std::int64_t i = 0; i < 12; ++i) profile.density[static_cast<std::size_t>(i)] *= 0.2;  // 0.08, above it 0.12
    CHECK_FALSE(find(profile));
    CHECK(find(profile, {.compression = 0.0}));
}

TEST_CASE("a bin packed beyond the equation of state counts as subsonic") {
    const fields::Profile profile = synthetic::Front{}.profile({0.0, 0.5, 80});
    const compare::Medium medium = synthetic::ideal_gas();
    std::vector<double> mach = compare::mach_numbers(profile, medium);
    for (std::size_t i = 0; i < 11; ++i) mach[i] = std::nan("");
    CHECK(compare::find_shock(profile, *compare::find_layer(profile), mach, medium));
}

TEST_CASE("noise of five percent in every bin moves a front by a fraction of a bin, and never loses it") {
    const synthetic::Front front{.location = 6.28, .half_width = 0.8};
    double squares = 0.0, width = 0.0;
    const int seeds = 50;
    for (int seed = 1; seed <= seeds; ++seed) {
        const auto shock = find(front.profile({0.0, 0.5, 80}, 0.05, static_cast<std::uint64_t>(seed)));
        INFO("seed " << seed);
        REQUIRE(shock);
        CHECK(shock->inside_layer);
        squares += std::pow(shock->location - front.exact_location(), 2);
        width += shock->width() / seeds;
    }
    // Statistics: a slope between bins has an error of 0.05 T sqrt(2)/width, 20 % of the steepest slope here.
    CHECK(std::sqrt(squares / seeds) < 0.2);
    // Extrema of noise on a flat part lie anywhere on it, so the mean width is biased by up to a bin at each end.
    CHECK(width == Approx(front.exact_foot() - front.exact_top()).margin(1.0));
}

TEST_CASE("heights do not depend on where the plate is") {
    const synthetic::Front front;
    fields::Profile low = front.profile({0.0, 0.5, 80});
    fields::Profile high = low;
    high.plate_height = 11.0;
    CHECK(find(low)->location == find(high)->location);
}

TEST_CASE("a layer whose temperature rises with height has no shock, noise or not") {
    const double noise = GENERATE(0.0, 0.05);
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        CHECK_FALSE(find(synthetic::quiet_profile({0.0, 0.5, 80}, noise, seed)));
}

TEST_CASE("a fall of temperature in a gas at rest is no shock") {
    CHECK_FALSE(find(synthetic::Front{.inflow = 0.3}.profile({0.0, 0.5, 80})));
}

TEST_CASE("a fall of temperature in a gas that flies away from the plate is no shock") {
    CHECK_FALSE(find(synthetic::Front{.inflow = -8.0}.profile({0.0, 0.5, 80})));
}

TEST_CASE("a front above the layer is found, and said to be outside") {
    // Density falls by e each sigma above 15: at 15.6 the gas is thinner than the layer and not yet too thin.
    synthetic::Front front{.location = 15.6, .half_width = 0.4};
    fields::Profile profile = front.profile({0.0, 0.5, 80});
    const auto shock = find(profile);
    REQUIRE(shock);
    CHECK_FALSE(shock->inside_layer);
}

TEST_CASE("width over mean free path uses the density at the front, between those of its two sides") {
    const synthetic::Front front;
    const fields::Profile profile = front.profile({0.0, 0.5, 80});
    const auto shock = find(profile);
    REQUIRE(shock);
    const double density = front.volume_fraction(shock->location) * 6.0 / std::numbers::pi;
    // Truncation: the density is linear between bins, where the tanh bends by up to 2 %.
    CHECK(shock->mean_free_path ==
          Approx(std::sqrt(std::numbers::pi / 8) / (std::numbers::pi * density)).epsilon(0.03));
    CHECK(shock->mean_free_path_foot > shock->mean_free_path);
}

TEST_CASE("Mach numbers are speeds past the plate over the speed of sound, and none where nothing is") {
    fields::Profile p;
    p.bins = {0.0, 1.0, 3};
    p.density = {1.0, 1.0, 0.0};
    p.velocity = {5.0, -3.0, 0.0};
    p.temperature = {0.6, 2.4, 0.0};
    p.plate_velocity = 1.0;
    const auto mach = compare::mach_numbers(p, synthetic::ideal_gas());
    CHECK(mach[0] == Approx(4.0));  // c = 1
    CHECK(mach[1] == Approx(2.0));  // c = 2
    CHECK(std::isnan(mach[2]));
}
