// SPDX-License-Identifier: MIT
// Observed orders on smooth flow: a density wave of constant pressure and velocity, which the inviscid equations carry
// along unchanged, in a periodic tube. Cell values are averages of mass and energy, so that fifth order can be seen.
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <vector>

#include "cases.hpp"
#include "continuum/closures/closures.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

using namespace continuum;

namespace {

constexpr double length = 1.0, speed = 1.0, pressure = 1.0;

double density_at(double z) { return 0.6 + 0.2 * std::sin(2.0 * std::numbers::pi * z / length); }
double heat_at(double z) {  // 3/2 n T at the pressure
    const double n = density_at(z);
    return 1.5 * pressure / (pressure_point<Goldshtein>(n, 1.0, 4.0).pressure / n);
}

/// Average over a cell: Gauss's rule of three points, error h^6.
template <class F>
double average(const F& f, double centre, double h) {
    const double off = 0.5 * h * std::sqrt(0.6);
    return (5.0 * f(centre - off) + 8.0 * f(centre) + 5.0 * f(centre + off)) / 18.0;
}

Evolution wave(std::int64_t cells, const char* scheme, double cfl) {
    Setup setup = cases::tube(cells, length, End::periodic, End::periodic, [](double) {
        return cases::Point{0.1, speed, 1.0};
    });
    for (std::int64_t i = 0; i < cells; ++i) {
        const auto k = static_cast<std::size_t>(setup.grid.first(0) + i);
        const double z = setup.grid.centre(i);
        setup.flow.density[k] = average(density_at, z, setup.grid.dz);
        setup.flow.temperature[k] = average(heat_at, z, setup.grid.dz) / (1.5 * setup.flow.density[k]);
    }
    setup.choices.scheme.name = scheme;
    setup.choices.limiter.name = "mc";
    setup.choices.cfl = cfl;
    return Evolution(setup);
}

/// Mean error of the density after a whole passage through the tube.
double error(std::int64_t cells, const char* scheme, double cfl) {
    Evolution evolution = wave(cells, scheme, cfl);
    cases::advance(evolution, length / speed);
    double sum = 0.0;
    for (std::int64_t i = 0; i < cells; ++i)
        sum += std::abs(evolution.flow().density[static_cast<std::size_t>(evolution.grid().first(0) + i)] -
                        average(density_at, evolution.grid().centre(i), evolution.grid().dz));
    return sum / static_cast<double>(cells);
}

/// How far the fields at the end are from those of 16 times as many steps, with `steps` steps and with twice as many.
std::array<double, 2> errors_in_time(const std::function<std::vector<double>(std::int64_t)>& field_after,
                                     std::int64_t steps) {
    const std::vector<double> exact = field_after(16 * steps);
    const auto error = [&](std::int64_t n) {
        const std::vector<double> found = field_after(n);
        double sum = 0.0;
        for (std::size_t i = 0; i < found.size(); ++i) sum += std::abs(found[i] - exact[i]);
        return sum / static_cast<double>(found.size());
    };
    return {error(steps), error(2 * steps)};
}

}  // namespace

TEST_CASE("the error of a smooth wave falls with the order of the scheme", "[convergence]") {
    struct Case {
        const char* scheme;
        std::array<std::int64_t, 3> cells;
        double order, margin;
    };
    const Case c = GENERATE(Case{"muscl", {32, 64, 128}, 2.0, 0.25}, Case{"weno5", {16, 32, 64}, 5.0, 0.35});
    double last = 0.0, order = 0.0;
    for (const std::int64_t cells : c.cells) {
        // Steps shrink as the error in space does: RK3 with dt ~ dz^(5/3), RK2 with dt ~ dz.
        const double cfl = c.order > 3.0 ? 0.4 * std::pow(16.0 / static_cast<double>(cells), 2.0 / 3.0) : 0.4;
        const double now = error(cells, c.scheme, cfl);
        if (last > 0.0) order = std::log2(last / now);
        std::printf("%-8s %4ld cells   error %.3e   order %s\n", c.scheme, static_cast<long>(cells), now,
                    last > 0.0 ? std::to_string(order).substr(0, 4).c_str() : "-");
        last = now;
    }
    // The last doubling; limiters clip the two extrema of the wave, which costs MUSCL a little.
    CHECK(order == Approx(c.order).margin(c.margin));
}

TEST_CASE("the error of a smooth wave falls with the order of the integrator", "[convergence]") {
    struct Case {
        const char* scheme;
        double order;
    };
    const Case c = GENERATE(Case{"muscl", 2.0}, Case{"weno5", 3.0});
    const auto density = [&](std::int64_t steps) {
        Evolution evolution = wave(32, c.scheme, 0.5);
        const double dt = 0.3 / static_cast<double>(steps);
        for (std::int64_t k = 0; k < steps; ++k) evolution.step(0.0, dt);
        return cases::inside(evolution, evolution.flow().density);
    };
    const auto [coarse, fine] = errors_in_time(density, 80);
    const double order = std::log2(coarse / fine);
    std::printf("%-8s in time   %.3e  %.3e   order %.2f\n", c.scheme, coarse, fine, order);
    // Limiters and weights are not smooth functions of the state: a fifth of an order.
    CHECK(order == Approx(c.order).margin(0.3));
}

TEST_CASE("waves with viscosity and conduction and cooling are second order in time", "[convergence]") {
    const double restitution = GENERATE(1.0, 0.9);
    const char* closure = GENERATE("jenkins_richman", "garzo_dufty");
    const auto temperature = [&](std::int64_t steps) {
        Setup setup = cases::tube(32, 4.0, End::wall, End::wall, [](double z) {
            const double wave = std::cos(2.0 * std::numbers::pi * z / 4.0);
            return cases::Point{0.2 + 0.05 * wave, 0.2 * std::sin(2.0 * std::numbers::pi * z / 4.0), 1.0 - 0.3 * wave};
        });
        setup.choices.transport.name = "navier_stokes";
        setup.choices.closure.name = closure;
        setup.restitution = restitution;
        setup.sink = scene::RestitutionConstant{restitution};
        Evolution evolution(setup);
        const double dt = 0.4 / static_cast<double>(steps);
        for (std::int64_t k = 0; k < steps; ++k) evolution.step(0.0, dt);
        return cases::inside(evolution, evolution.flow().temperature);
    };
    const auto [coarse, fine] = errors_in_time(temperature, 80);
    const double order = std::log2(coarse / fine);
    std::printf("e = %.1f %-16s all terms, in time   %.3e  %.3e   order %.2f\n", restitution, closure, coarse, fine,
                order);
    // The limiter is no smooth function of the state: a fifth of an order.
    CHECK(order == Approx(2.0).margin(0.25));
}
