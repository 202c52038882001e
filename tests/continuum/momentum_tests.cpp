// SPDX-License-Identifier: MIT
// The books of momentum: what plate and upper end have given, each by itself, is what the column has gained.
#include <cmath>

#include "cases.hpp"
#include "continuum/closures/closures.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

using namespace continuum;
using cases::Point;

namespace {

double momentum(const Evolution& evolution) {
    const std::vector<double> n = cases::inside(evolution, evolution.flow().density),
                              u = cases::inside(evolution, evolution.flow().velocity_z);
    double sum = 0.0;
    for (std::size_t i = 0; i < n.size(); ++i) sum += n[i] * u[i] * evolution.grid().dz;
    return sum;
}

/// Gas that rises, denser and hotter below, between two walls that it both meets.
Setup rising(double gravity, bool upside_down = false) {
    Setup setup = cases::tube(40, 10.0, End::wall, End::wall, [&](double at) {
        const double z = upside_down ? 10.0 - at : at;
        return Point{0.3 - 0.02 * z, (upside_down ? -1.0 : 1.0) * (0.4 + 0.05 * z), 2.0 - 0.1 * z};
    });
    setup.gravity = gravity;
    setup.choices.transport.name = "navier_stokes";
    setup.sink = scene::RestitutionConstant{0.9};
    return setup;
}

void advance(Evolution& evolution, int steps, double dt) {
    for (int k = 0; k < steps; ++k) evolution.step(dt * k, dt);
}

}  // namespace

TEST_CASE("what plate and upper end give, less the weight, is what the column gains, to round-off", "[conservation]") {
    Evolution evolution(rising(1.0));
    const double before = momentum(evolution);
    const int steps = 500;
    const double dt = 0.01;
    advance(evolution, steps, dt);
    const Ledger books = evolution.ledger();
    REQUIRE(std::abs(books.plate_impulse) > 1.0);
    REQUIRE(std::abs(books.lid_impulse) > 0.5);
    const double given = books.plate_impulse - books.lid_impulse - evolution.mass() * steps * dt;
    CHECK(momentum(evolution) - before == Approx(given).margin(1e-12 * books.plate_impulse));  // round-off of 500 steps
}

TEST_CASE("each end keeps its own book: of a column upside down they are exchanged", "[conservation]") {
    Evolution upright(rising(0.0)), turned(rising(0.0, true));
    advance(upright, 300, 0.01);
    advance(turned, 300, 0.01);
    const Ledger one = upright.ledger(), other = turned.ledger();
    REQUIRE(std::abs(one.plate_impulse - one.lid_impulse) > 0.1 * one.plate_impulse);
    CHECK(other.lid_impulse == Approx(one.plate_impulse).epsilon(1e-11));  // round-off of 300 steps
    CHECK(other.plate_impulse == Approx(one.lid_impulse).epsilon(1e-11));
}

TEST_CASE("in a first short step each end bears the pressure of the gas that rests on it") {
    const auto state = [](double z) { return z < 5.0 ? Point{0.3, 0.0, 2.0} : Point{0.1, 0.0, 1.0}; };
    Evolution evolution(cases::tube(40, 10.0, End::wall, End::wall, state));
    const double dt = 1e-6;
    evolution.step(0.0, dt);
    const auto pressure = [](const Point& p) {
        return pressure_point<Goldshtein>(p.volume_fraction / sphere_volume, p.temperature, 4.0).pressure;
    };
    // The gas at the ends rests, and what begins in the middle does not reach them: round-off.
    CHECK(evolution.ledger().plate_impulse / dt == Approx(pressure(state(0.0))).epsilon(1e-12));
    CHECK(evolution.ledger().lid_impulse / dt == Approx(pressure(state(9.9))).epsilon(1e-12));
}

TEST_CASE("on a moving plate the books close in the lab, with the second order of the steps", "[conservation]") {
    const auto gap = [](double dt) {
        Setup setup = rising(1.0);
        setup.motion = scene::PlateMotion::from_acceleration(2.0, 0.3);
        Evolution evolution(setup);
        const double before = momentum(evolution);
        const int steps = static_cast<int>(std::lround(1.0 / dt));
        advance(evolution, steps, dt);
        const Ledger books = evolution.ledger();
        const double in_lab = momentum(evolution) + evolution.mass() * setup.motion.velocity(1.0);  // it starts at rest
        return in_lab - before - (books.plate_impulse - books.lid_impulse - evolution.mass());
    };
    const double coarse = gap(0.01), fine = gap(0.005);
    INFO("gap " << coarse << " with steps of 0.01, " << fine << " with steps of 0.005");
    CHECK(std::abs(coarse) < 1e-3);  // truncation: a quadrature of second order over thirty steps a period
    CHECK(coarse / fine == Approx(4.0).epsilon(0.01));
}
