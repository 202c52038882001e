// SPDX-License-Identifier: MIT
// Elementary functions of our own against the C library's in long double.
#include "scene/elementary.hpp"

#include <algorithm>

#include "scene/random_stream.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

using namespace scene;

namespace {

constexpr long double pi = std::numbers::pi_v<long double>;
constexpr double ulp = 2.220446049250313e-16;  // of 1

template <class Function, class Reference>
double worst_relative_error(double from, double to, Function ours, Reference exact) {
    RandomStream random(7);
    double worst = 0.0;
    for (int i = 0; i < 100000; ++i) {
        const double x = random.uniform(from, to);
        const long double e = exact(static_cast<long double>(x));
        worst = std::max(worst, static_cast<double>(std::abs((static_cast<long double>(ours(x)) - e) / e)));
    }
    return worst;
}

}  // namespace

TEST_CASE("sine and cosine of turns are right within an ulp of 1 and exact at quarters") {
    RandomStream random(7);
    double worst = 0.0;
    for (int i = 0; i < 100000; ++i) {
        const double turns = random.uniform(-3.0, 3.0);
        const SineCosine at = sine_cosine_of_turns(turns);
        worst = std::max({worst, static_cast<double>(std::abs(at.sine - std::sin(2.0L * pi * turns))),
                          static_cast<double>(std::abs(at.cosine - std::cos(2.0L * pi * turns)))});
    }
    CHECK(worst < ulp);  // round-off: half an ulp of the angle, half of the sum
    for (int quarter = -8; quarter <= 8; ++quarter) {
        constexpr double sines[4] = {0.0, 1.0, 0.0, -1.0};
        const SineCosine at = sine_cosine_of_turns(0.25 * quarter);
        CHECK(at.sine == sines[(quarter + 8) % 4]);
        CHECK(at.cosine == sines[(quarter + 9) % 4]);
    }
}

TEST_CASE("a small sine keeps its relative error, on both sides of a half turn") {
    const double near_half = GENERATE(0.0, 0.5, -0.5, 1.0);
    const auto sine = [&](double x) { return sine_cosine_of_turns(near_half + x).sine; };
    for (double x = 1e-3; x > 1e-9; x *= 0.37) {
        const double turns = near_half + x;  // rounded: what is left of it is exact
        const long double exact = std::sin(2.0L * pi * (static_cast<long double>(turns) - near_half));
        CHECK(std::abs(sine(x)) == Approx(static_cast<double>(exact)).epsilon(2.0 * ulp));
    }
}

TEST_CASE("logarithm, exponential, cube root and arc sine are right to round-off") {
    CHECK(worst_relative_error(1e-16, 1.0, natural_logarithm, [](long double x) { return std::log(x); }) < 4.0 * ulp);
    CHECK(worst_relative_error(1.0, 1e9, natural_logarithm, [](long double x) { return std::log(x); }) < 4.0 * ulp);
    CHECK(worst_relative_error(1e-9, 1e9, cube_root, [](long double x) { return std::cbrt(x); }) < 2.0 * ulp);
    CHECK(worst_relative_error(1e-9, 1.0, arc_sine, [](long double x) { return std::asin(x); }) < 6.0 * ulp);
    CHECK(arc_sine(1.0) == Approx(0.5 * std::numbers::pi).epsilon(2.0 * ulp));
    // The exponent's own rounding is |x| ulps of the result.
    CHECK(worst_relative_error(-2.0, 2.0, exponential, [](long double x) { return std::exp(x); }) < 4.0 * ulp);
    CHECK(worst_relative_error(-600.0, 600.0, exponential, [](long double x) { return std::exp(x); }) < 600.0 * ulp);
    CHECK(exponential(-1e6) == exponential(-700.0));
    CHECK(exponential(0.0) == 1.0);
}
