// SPDX-License-Identifier: MIT
// The Swift-Hohenberg equation against what can be said of it exactly: linear growth, the variance of its linear noise,
// a potential that falls, the amplitude of its stripes, and the order of its step.
#include "swift_hohenberg/simulation.hpp"

#include <cmath>

#include "swift_hohenberg/linear_theory.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;
using swift_hohenberg::Parameters;
using swift_hohenberg::Simulation;

namespace {

Parameters at(double control, double noise) {
    Parameters p;
    p.control = control;
    p.noise = noise;
    return p;
}

/// One stripe pattern of the critical wavelength along x, with a weak one along y.
std::vector<double> crossed_stripes(const Parameters& p) {
    std::vector<double> field;
    const double unit = p.side / static_cast<double>(p.points);
    for (std::int64_t j = 0; j < p.points; ++j)
        for (std::int64_t i = 0; i < p.points; ++i)
            field.push_back(0.3 * std::cos(unit * static_cast<double>(i)) +
                            0.05 * std::sin(unit * static_cast<double>(j)));
    return field;
}

}  // namespace

TEST_CASE("without the cubic term every mode grows at its own rate") {
    Parameters p = at(0.13, 0.0);
    p.cubic = false;
    Simulation simulation(p);
    std::vector<std::complex<double>> before;
    for (std::int64_t j = 0; j < p.points; ++j)
        for (std::int64_t i = 0; i <= p.points / 2; ++i) before.push_back(simulation.mode(i, j));
    constexpr int steps = 6;
    simulation.advance(steps);
    std::size_t k = 0;
    for (std::int64_t j = 0; j < p.points; ++j) {
        for (std::int64_t i = 0; i <= p.points / 2; ++i, ++k) {
            const double rate = swift_hohenberg::growth_rate(p, i, j);
            const double wanted = std::abs(before[k]) * std::exp(rate * p.step * steps);
            // Round-off of six products; modes that underflow are zero in both.
            REQUIRE(std::abs(std::abs(simulation.mode(i, j)) - wanted) <= 1e-13 * wanted + 1e-300);
        }
    }
}

TEST_CASE("noise without the cubic term has the variance of the box's own modes") {
    Parameters p = at(-0.2, 0.01);
    p.cubic = false;
    p.start = 0.0;
    Simulation simulation(p);
    simulation.advance(200);  // e^(-0.2 * 100) of the start is left
    // Blocks of 80 time units, 16 times the longest memory 1/(2 * 0.2) of a square.
    constexpr int blocks = 60, block = 160;
    double sum = 0.0, squares = 0.0;
    for (int b = 0; b < blocks; ++b) {
        double mean = 0.0;
        for (int i = 0; i < block; ++i) {
            simulation.step();
            mean += simulation.mean_square() / block;
        }
        sum += mean / blocks;
        squares += mean * mean / blocks;
    }
    const double error = std::sqrt((squares - sum * sum) / (blocks - 1));
    CHECK(error < 0.02 * sum);
    CHECK(std::abs(sum - swift_hohenberg::mean_square(p)) < 3.0 * error);
}

TEST_CASE("without noise the potential never rises") {
    Parameters p = at(0.2, 0.0);
    p.start = 0.5;
    Simulation simulation(p);
    double before = simulation.potential();
    const double first = before;
    for (int i = 0; i < 400; ++i) {
        simulation.step();
        const double now = simulation.potential();
        REQUIRE(now <= before + 1e-15);  // round-off
        before = now;
    }
    CHECK(before < 0.0);
    CHECK(before < first);
}

TEST_CASE("stripes settle at the amplitude of the amplitude equation") {
    // psi = A cos x with A^2 = 4 epsilon / 3; the third harmonic, damped at 64, changes it by order epsilon/64.
    Parameters p = at(0.05, 0.0);
    Simulation simulation(p);
    simulation.set_field(crossed_stripes(p));
    simulation.advance(4000);
    const auto across = static_cast<std::int64_t>(p.side / (2.0 * M_PI) + 0.5);
    CHECK(2.0 * std::abs(simulation.mode(across, 0)) == Approx(std::sqrt(4.0 * 0.05 / 3.0)).epsilon(2e-3));
    CHECK(std::abs(simulation.mode(0, across)) < 1e-12);
}

TEST_CASE("the step is of second order") {
    const auto after_four = [](double step) {
        Parameters p = at(0.2, 0.0);
        p.step = step;
        Simulation simulation(p);
        simulation.set_field(crossed_stripes(p));
        simulation.advance(std::llround(4.0 / step));
        return simulation.field();
    };
    const auto exact = after_four(1.0 / 1024.0);
    const auto error = [&](double step) {
        const auto field = after_four(step);
        double largest = 0.0;
        for (std::size_t i = 0; i < field.size(); ++i) largest = std::max(largest, std::abs(field[i] - exact[i]));
        return largest;
    };
    const double order = std::log2(error(0.125) / error(0.0625));
    CHECK(order == Approx(2.0).margin(0.1));
}

TEST_CASE("a seed gives one field, another seed another") {
    const auto field_of = [](std::uint64_t seed) {
        Parameters p = at(0.1, 0.01);
        p.seed = seed;
        Simulation simulation(p);
        simulation.advance(50);
        return simulation.field();
    };
    CHECK(field_of(4) == field_of(4));
    CHECK(field_of(4) != field_of(5));
}

TEST_CASE("parameters out of range are refused") {
    CHECK_THROWS_AS(Simulation(at(0.0, -1.0)), std::invalid_argument);
    Parameters p;
    p.points = 2;
    CHECK_THROWS_AS(Simulation(p), std::invalid_argument);
    Simulation simulation{Parameters{}};
    CHECK_THROWS_AS(simulation.set_field({1.0}), std::invalid_argument);
}
