// SPDX-License-Identifier: MIT
// The source's finite differences: right where the flow is smooth, first order in time, second in space; and what they
// do not keep is measured.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "cases.hpp"
#include "continuum/ftcs/ftcs.hpp"
#include "continuum/solver.hpp"
#include "scene/errors.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

using namespace continuum;

namespace {

constexpr double length = 8.0;

/// A standing wave between two walls, with every term on: u = 0 and d/dz = 0 of all else at the walls.
Setup standing_wave(std::int64_t cells, const char* scheme) {
    Setup setup = cases::tube(cells, length, End::wall, End::wall, [](double z) {
        const double wave = std::cos(std::numbers::pi * z / length);
        return cases::Point{0.2 * (1.0 + 0.2 * wave), 0.0, 1.0 + 0.1 * wave};
    });
    setup.choices.transport.name = "navier_stokes";
    setup.choices.closure.name = "jenkins_richman_dense";
    setup.choices.scheme.name = scheme;
    setup.choices.artificial_dissipation = 0.0;
    setup.sink = scene::RestitutionConstant{0.9};
    setup.restitution = 0.9;
    return setup;
}

/// After the same time in equal steps.
std::vector<double> density_after(Method& method, double duration, std::int64_t steps) {
    for (std::int64_t k = 0; k < steps; ++k) method.step(0.0, duration / static_cast<double>(steps));
    const auto first = method.flow().density.begin() + method.grid().first(0);
    return {first, first + method.grid().nz};
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]) / static_cast<double>(a.size());
    return sum;
}

/// Means over pairs, fours, ... of cells.
std::vector<double> coarsened(const std::vector<double>& fine, std::size_t cells) {
    const std::size_t share = fine.size() / cells;
    std::vector<double> means(cells, 0.0);
    for (std::size_t i = 0; i < fine.size(); ++i) means[i / share] += fine[i] / static_cast<double>(share);
    return means;
}

}  // namespace

TEST_CASE("ftcs is first order in time", "[convergence]") {
    const auto density = [](std::int64_t steps) {
        Ftcs method(standing_wave(32, "ftcs"));
        return density_after(method, 0.5, steps);
    };
    const std::vector<double> exact = density(6400);
    const double coarse = difference(density(200), exact), fine = difference(density(400), exact);
    const double order = std::log2(coarse / fine);
    std::printf("ftcs     in time   %.3e  %.3e   order %.2f\n", coarse, fine, order);
    // The reference has 1/32 of the coarse step's error itself: 0.05 of an order.
    CHECK(order == Approx(1.0).margin(0.08));
}

TEST_CASE("ftcs converges to the flow that the finite volumes converge to, at second order in space", "[convergence]") {
    const double duration = 0.5;
    const auto muscl = make_method(standing_wave(512, "muscl"));
    const std::vector<double> reference = density_after(*muscl, duration, 4000);
    const auto error = [&](std::int64_t cells, std::int64_t steps) {
        Ftcs method(standing_wave(cells, "ftcs"));
        return difference(density_after(method, duration, steps),
                          coarsened(reference, static_cast<std::size_t>(cells)));
    };
    // dt ~ dz^2, so that the error in time falls as that in space does.
    const double coarse = error(16, 200), fine = error(32, 800), order = std::log2(coarse / fine);
    std::printf("ftcs     in space  %.3e  %.3e   order %.2f\n", coarse, fine, order);
    CHECK(order == Approx(2.0).margin(0.3));
    // Waves of amplitude 0.08 in density, sixteen points over half a wavelength: (pi/16)^2/6 of them and the time
    // error.
    CHECK(coarse < 2e-3);
}

TEST_CASE("ftcs in three dimensions keeps the answer of one column, and turns with the flow") {
    const auto uniform = [](std::int64_t nx, std::int64_t ny) {
        const Setup one = standing_wave(24, "ftcs");
        Grid grid = one.grid;
        grid.nx = nx;
        grid.ny = ny;
        Setup setup = one;
        setup.grid = grid;
        setup.flow = Flow(grid);
        for (std::int64_t c = 0; c < grid.columns(); ++c)
            for (std::int64_t i = 0; i < grid.nz; ++i) {
                const auto to = static_cast<std::size_t>(grid.first(c) + i);
                const auto from = static_cast<std::size_t>(one.grid.first(0) + i);
                setup.flow.density[to] = one.flow.density[from];
                setup.flow.temperature[to] = one.flow.temperature[from];
            }
        return setup;
    };
    Ftcs column(uniform(1, 1)), block(uniform(4, 3));
    const std::vector<double> a = density_after(column, 0.2, 100), b = density_after(block, 0.2, 100);
    CHECK(a == b);

    // A wave along x and the same along y: equal to the last digits, sums are taken in another order.
    const auto wave = [](bool along_x) {
        Grid grid;
        grid.nx = along_x ? 12 : 1;
        grid.ny = along_x ? 1 : 12;
        grid.nz = 16;
        Setup setup(grid);
        setup.choices.scheme.name = "ftcs";
        setup.choices.closure.name = "jenkins_richman_dense";
        for (std::int64_t c = 0; c < grid.columns(); ++c)
            for (std::int64_t i = 0; i < grid.nz; ++i) {
                const auto k = static_cast<std::size_t>(grid.first(c) + i);
                const double angle = 2.0 * std::numbers::pi * static_cast<double>(c) / 12.0;
                setup.flow.density[k] = 0.4 + 0.05 * std::sin(angle);
                (along_x ? setup.flow.velocity_x : setup.flow.velocity_y)[k] = 0.2 * std::cos(angle);
            }
        return setup;
    };
    Ftcs along_x(wave(true)), along_y(wave(false));
    for (int k = 0; k < 200; ++k) {
        along_x.step(0.0, 0.005);
        along_y.step(0.0, 0.005);
    }
    const auto at = [](const Ftcs& method, std::int64_t c) {
        return method.flow().density[static_cast<std::size_t>(method.grid().first(c) + 5)];
    };
    for (std::int64_t c = 0; c < 12; ++c) CHECK(at(along_x, c) == Approx(at(along_y, c)).epsilon(1e-12));
    CHECK(at(along_x, 3) != Approx(0.45).epsilon(1e-3));
}

TEST_CASE("ftcs does not keep the mass where the flow is steep") {
    Setup setup = cases::tube(64, length, End::wall, End::wall, [](double z) {
        return cases::Point{z < 3.0 ? 0.3 : 0.3 * std::exp(-(z - 3.0)), -0.5, 1.0};
    });
    setup.choices.transport.name = "navier_stokes";
    setup.choices.scheme.name = "ftcs";
    setup.choices.closure.name = "jenkins_richman_dense";
    Ftcs method(setup);
    const double mass = method.mass();
    cases::advance(method, 1.0);
    // Truncation: some 1e-3 of the mass, against 1e-15 of the finite volumes. None of it is the floor's doing.
    const double gained = std::abs(method.mass() / mass - 1.0);
    INFO("share of the mass made or lost: " << gained);
    CHECK(gained > 1e-6);
    CHECK(gained < 1e-2);
    CHECK(method.floor_mass() == 0.0);
}

TEST_CASE("ftcs carries the layer of chapter 4 through two cycles and its landing") {
    const auto heights = [](const char* scheme) {
        scene::Scene scene;
        scene.particles.restitution = scene::RestitutionConstant{0.9};
        scene.number_of_particles = 3937;
        scene.motion = scene::PlateMotion::from_acceleration(3.0, 0.095);
        scene.sample.phases = 10;
        scene.continuum.scheme.name = scheme;
        scene.continuum.upper.name = "lid";
        scene.continuum.closure.name = "jenkins_richman_dense";
        Solver solver(scene);
        std::vector<double> z;
        for (std::int64_t k = 1; k <= 20; ++k) {
            solver.advance_to_instant(k / 10, k % 10);
            const ColumnView column = solver.column(0, 0);
            double mass = 0.0, moment = 0.0;
            for (std::size_t i = 0; i < column.density.size(); ++i) {
                mass += column.density[i];
                moment += column.density[i] * (static_cast<double>(i) + 0.5) * solver.spacing_z();
            }
            z.push_back(scene.motion.position(solver.time_in_cycle()) + moment / mass);
        }
        return z;
    };
    const std::vector<double> source = heights("ftcs"), ours = heights("muscl");
    double squares = 0.0;
    for (std::size_t k = 0; k < ours.size(); ++k)
        squares += (source[k] / ours[k] - 1.0) * (source[k] / ours[k] - 1.0) / static_cast<double>(ours.size());
    INFO("rms difference of z_cm " << 100.0 * std::sqrt(squares) << " %");
    // Truncation of the source's method at dz = 0.2: 2 to 3 % once settled.
    CHECK(std::sqrt(squares) < 0.04);
}

TEST_CASE("ftcs refuses ends that it does not know") {
    Setup setup = cases::tube(32, length, End::periodic, End::periodic, [](double) { return cases::Point{0.2, 0, 1}; });
    setup.choices.scheme.name = "ftcs";
    setup.choices.closure.name = "jenkins_richman_dense";
    CHECK_THROWS_WITH(make_method(setup), Contains("knows walls only"));
    setup.boundaries.lower.end = End::wall;
    setup.boundaries.upper.end = End::stress_free;
    CHECK_THROWS_WITH(make_method(setup), Contains("stress_free") && Contains("known with it: lid"));
}
