// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <random>

#include "continuum/closures/goldshtein.hpp"
#include "continuum/flux/fluxes.hpp"
#include "continuum/reconstruct/limiters.hpp"
#include "continuum/reconstruct/muscl.hpp"
#include "continuum/reconstruct/weno5.hpp"
#include "continuum/sweep.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

using namespace continuum;

namespace {

constexpr double packing = Goldshtein::packing / sphere_volume;

double uniform(std::mt19937_64& engine, double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
}

FaceState random_state(std::mt19937_64& engine) {
    const double nu = std::exp(uniform(engine, std::log(1e-8), std::log(0.649)));
    const FaceValues values{nu / sphere_volume, uniform(engine, -5, 5), uniform(engine, -2, 2), uniform(engine, -2, 2),
                            std::exp(uniform(engine, std::log(1e-6), std::log(10.0)))};
    return face_state<Goldshtein>(values, 3.8);
}

FaceState mirrored(FaceState s) {
    s.normal = -s.normal;
    return s;
}

}  // namespace

TEMPLATE_TEST_CASE("the flux between two equal states is the flux of that state", "", FluxHll, FluxHllc) {
    std::mt19937_64 engine(1);
    for (int trial = 0; trial < 1000; ++trial) {
        const FaceState s = random_state(engine);
        const FaceFlux f = TestType::at(s, s, packing);
        const double u = s.normal, mass = s.density * u;
        const double energy = 1.5 * s.density * s.temperature +
                              0.5 * s.density * (u * u + s.tangent_1 * s.tangent_1 + s.tangent_2 * s.tangent_2);
        // Round-off of terms that cancel: a few ulp of the largest wave times the density of what is carried.
        const double wave = std::abs(u) + s.sound_speed;
        const auto near = [&](double value, double scale) { return Approx(value).margin(1e-14 * scale); };
        CHECK(f.mass == near(mass, s.density * wave));
        CHECK(f.normal == near(mass * u + s.pressure, s.density * wave * wave));
        CHECK(f.tangent_1 == near(mass * s.tangent_1, s.density * wave * 2));
        CHECK(f.tangent_2 == near(mass * s.tangent_2, s.density * wave * 2));
        CHECK(f.energy == near((energy + s.pressure) * u, (energy + s.pressure + s.density * wave * wave) * wave));
        CHECK(f.velocity == near(u, wave));
    }
}

TEMPLATE_TEST_CASE("the mirrored Riemann problem has the mirrored flux, bit for bit", "", FluxHll, FluxHllc) {
    std::mt19937_64 engine(2);
    for (int trial = 0; trial < 10000; ++trial) {
        const FaceState left = random_state(engine), right = random_state(engine);
        const FaceFlux f = TestType::at(left, right, packing);
        const FaceFlux m = TestType::at(mirrored(right), mirrored(left), packing);
        REQUIRE(m.mass == -f.mass);
        REQUIRE(m.normal == f.normal);
        REQUIRE(m.tangent_1 == -f.tangent_1);
        REQUIRE(m.energy == -f.energy);
        REQUIRE(m.internal == -f.internal);
        REQUIRE(m.velocity == -f.velocity);
        REQUIRE(m.signal == f.signal);
    }
}

TEST_CASE("hllc keeps a resting contact, hll smears it") {
    const double p = 1.0;
    const auto at_pressure = [&](double nu) {
        const double unit = pressure_point<Goldshtein>(nu / sphere_volume, 1.0, 4.0).pressure;
        return face_state<Goldshtein>({nu / sphere_volume, 0.0, 0.3, 0.0, p / unit}, 4.0);
    };
    const FaceState dense = at_pressure(0.5), dilute = at_pressure(0.05);
    const FaceFlux sharp = FluxHllc::at(dense, dilute, packing);
    CHECK(std::abs(sharp.mass) < 1e-14);  // round-off of equal pressures
    CHECK(sharp.normal == Approx(p).epsilon(1e-14));
    CHECK(FluxHll::at(dense, dilute, packing).mass > 0.1);
}

TEST_CASE("the waves are wide enough that two streams meeting stay below packing") {
    std::mt19937_64 engine(3);
    for (int trial = 0; trial < 10000; ++trial) {
        const FaceState left = random_state(engine), right = random_state(engine);
        const WaveSpeeds s = wave_speeds(left, right, packing);
        // Integral of the mass balance over the fan.
        const double between = (right.density * (s.fastest - right.normal) + left.density * (left.normal - s.slowest)) /
                               (s.fastest - s.slowest);
        REQUIRE(between > 0.0);
        REQUIRE(between < packing);
    }
}

TEMPLATE_TEST_CASE("a limiter keeps straight lines, is odd and symmetric, and stays between the neighbours", "",
                   LimiterMinmod, LimiterVanLeer, LimiterMonotonizedCentral) {
    CHECK(TestType::slope(0.25, 0.25) == 0.25);
    CHECK(TestType::slope(1.0, -0.5) == 0.0);
    CHECK(TestType::slope(0.0, 1.0) == 0.0);
    std::mt19937_64 engine(4);
    for (int trial = 0; trial < 1000; ++trial) {
        const double a = uniform(engine, -1, 1), b = uniform(engine, -1, 1);
        REQUIRE(TestType::slope(a, b) == TestType::slope(b, a));
        REQUIRE(TestType::slope(-a, -b) == -TestType::slope(a, b));
        // Half a slope to either side must not pass a neighbour.
        REQUIRE(0.5 * std::abs(TestType::slope(a, b)) <= std::min(std::abs(a), std::abs(b)) * (1.0 + 1e-15));
    }
}

TEST_CASE("WENO is exact on parabolas, and of fifth order on what is smooth") {
    // Averages of z^2 over unit cells centred at -2 to 2; the edge lies at 1/2.
    const auto square = [](double z) { return z * z + 1.0 / 12.0; };
    CHECK(Weno5<>::edge(square(-2), square(-1), square(0), square(1), square(2)) == Approx(0.25).epsilon(1e-13));
    const auto error = [](double h) {
        const auto mean = [&](double z) { return (std::cos(z - 0.5 * h) - std::cos(z + 0.5 * h)) / h; };
        const double z = 0.7;
        return std::abs(Weno5<>::edge(mean(z - 2 * h), mean(z - h), mean(z), mean(z + h), mean(z + 2 * h)) -
                        std::sin(z + 0.5 * h));
    };
    CHECK(std::log2(error(0.2) / error(0.1)) == Approx(5.0).margin(0.4));
    CHECK(Weno5<>::edge(3.0, 3.0, 3.0, 3.0, 3.0) == Approx(3.0).epsilon(1e-15));
}

TEST_CASE("no scheme lets more out of a cell beside an emptier one than it holds") {
    // Gas that falls away from an end leaves cells of 1e-16 of its density behind: what a face carries must be in
    // proportion to the cell that it leaves. Twice the cell's own density is where slopes are limited.
    std::mt19937_64 engine(5);
    const auto at_most_twice = [&](auto reconstruct) {
        using Reconstruct = decltype(reconstruct);
        double largest = 0.0;
        bool is_finite = true;
        for (int trial = 0; trial < 1000; ++trial) {
            double density[6], normal[6], zero[6]{}, temperature[6];
            for (int k = 0; k < 6; ++k) {
                density[k] = std::exp(uniform(engine, std::log(1e-80), std::log(1e-8)));
                normal[k] = uniform(engine, -3.0, 3.0);
                temperature[k] = uniform(engine, 3.0, 4.0);
            }
            Stencil s;
            for (std::size_t k = 0; k < 6; ++k) {
                s.density[k] = &density[k];
                s.normal[k] = &normal[k];
                s.tangent_1[k] = s.tangent_2[k] = &zero[k];
                s.temperature[k] = &temperature[k];
            }
            const FaceValues below = Reconstruct::below(s, 0, packing), above = Reconstruct::above(s, 0, packing);
            largest = std::max({largest, below.density / density[2], above.density / density[3]});
            // Where rounding leaves a face without gas, its velocity and the energy it carries are 0/0.
            const FaceFlux flux =
                FluxHllc::at(face_state<Goldshtein>(below, 3.8), face_state<Goldshtein>(above, 3.8), packing);
            is_finite &= std::isfinite(flux.mass) && std::isfinite(flux.normal) && std::isfinite(flux.energy) &&
                         std::isfinite(flux.velocity);
        }
        CHECK(is_finite);
        CHECK(largest <= 2.0 * (1.0 + 1e-12));  // round-off
        CHECK(largest > 1.5);                   // the states reach the bound
    };
    at_most_twice(Weno5<true>{});
    at_most_twice(Weno5<false>{});
    at_most_twice(Muscl<LimiterVanLeer>{});
}

TEST_CASE("MUSCL is exact on straight lines") {
    const std::array<double, 6> line{1.0, 1.5, 2.0, 2.5, 3.0, 3.5};
    CHECK(Muscl<LimiterVanLeer>::left(line) == 2.25);
    CHECK(Muscl<LimiterVanLeer>::right(line) == 2.25);
}
