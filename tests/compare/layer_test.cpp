// SPDX-License-Identifier: MIT
#include "compare/layer.hpp"

#include <numbers>

#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

fields::Profile profile_of(const std::vector<double>& volume_fraction, double bin_width = 1.0) {
    fields::Profile p;
    p.bins = {0.0, bin_width, static_cast<std::int64_t>(volume_fraction.size())};
    for (const double nu : volume_fraction) p.density.push_back(nu * 6.0 / std::numbers::pi);
    return p;
}

}  // namespace

TEST_CASE("the edges of a layer lie where a linear profile crosses the threshold") {
    // nu rises by 0.01 a bin from 0 and falls again: the line through the centres crosses 0.026 at 2.6 bins.
    const auto layer = compare::find_layer(profile_of({0.0, 0.01, 0.02, 0.03, 0.04, 0.03, 0.02, 0.01, 0.0}));
    REQUIRE(layer);
    CHECK(layer->lower == Approx(0.5 + 2.6).margin(1e-12));  // round-off
    CHECK(layer->upper == Approx(0.5 + 5.4).margin(1e-12));
    CHECK(layer->first_bin == 3);
    CHECK(layer->last_bin == 5);
}

TEST_CASE("a layer on the plate begins at the plate, and one at the lid ends there") {
    const auto layer = compare::find_layer(profile_of({0.3, 0.3, 0.2}, 0.5));
    REQUIRE(layer);
    CHECK(layer->lower == 0.0);
    CHECK(layer->upper == 1.5);
}

TEST_CASE("empty bins between packed planes do not cut a layer") {
    const auto layer = compare::find_layer(profile_of({0.0, 0.9, 0.0, 0.9, 0.0, 0.5, 0.5, 0.0}));
    REQUIRE(layer);
    CHECK(layer->first_bin == 1);
    CHECK(layer->last_bin == 6);
}

TEST_CASE("a gas below the threshold is no layer") {
    CHECK_FALSE(compare::find_layer(profile_of({0.0, 0.01, 0.025, 0.01, 0.0})));
}
