// SPDX-License-Identifier: MIT
// The plate's contact against a method that cannot skip a root: as the gap's acceleration is at most 1 + Gamma in size,
// from a gap h with rate h' no contact comes before s with h + h' s - (1 + Gamma) s^2/2 = 0. Marching by such steps, in
// extended precision, runs into the first contact and never past it.
#include <cmath>

#include "md/contact_time.hpp"
#include "md/plate_contact_time.hpp"
#include "md/simulation.hpp"
#include "scene/random_stream.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

struct Flight {
    scene::PlateMotion plate;
    double height, velocity, now;

    long double omega() const { return plate.angular_frequency(); }
    long double gap(long double t) const {
        const long double flight = t - now;
        return height + flight * (velocity - flight / 2) - plate.amplitude * (1 - std::cos(omega() * t));
    }
    long double rate(long double t) const {
        return velocity - (t - now) - plate.amplitude * omega() * std::sin(omega() * t);
    }
};

struct Marched {
    double time = md::never;
    long double nearest = 1e300L;  // smallest gap passed without a contact
};

Marched march(const Flight& flight, double until) {
    const long double bound = 1 + flight.plate.peak_acceleration();
    constexpr long double touching = 1e-15L;
    Marched result;
    long double t = flight.now;
    while (t <= until) {
        const long double h = flight.gap(t), rate = flight.rate(t);
        if (h <= touching && rate < 0) {
            result.time = static_cast<double>(t);
            return result;
        }
        if (rate <= 0) result.nearest = std::min(result.nearest, h);
        const long double depth = std::max(h, 0.0L);
        t += std::max((rate + std::sqrt(rate * rate + 2 * bound * depth)) / bound, 1e-12L);
    }
    return result;
}

/// Checks one flight; returns whether there was a contact.
bool agree(const Flight& flight, double until) {
    const double t = md::plate_contact_time(flight.plate, flight.height, flight.velocity, flight.now, until);
    const Marched expected = march(flight, until);
    INFO("height " << flight.height << ", velocity " << flight.velocity << ", from " << flight.now << " until " << until
                   << ": found " << t << ", marched " << expected.time);
    const long double scale = 1 + std::abs(flight.height) + flight.velocity * flight.velocity;
    const long double round_off = 1e-14L * scale;  // some twenty operations on heights of this size
    if (t == md::never) {
        // A contact may hang on the last bit only where the gap just reaches zero, or just before the end.
        const bool last_bit =
            expected.time == md::never || until - expected.time < 1e-9 || std::abs(flight.rate(expected.time)) < 1e-6;
        REQUIRE(last_bit);
        return false;
    }
    REQUIRE(std::abs(flight.gap(t)) < round_off);
    REQUIRE(flight.rate(t) < 1e-6L);
    if (expected.time != md::never) {
        REQUIRE(t > expected.time - 1e-6);  // a grazing root is good to the root of round-off
        REQUIRE(t < expected.time + 1e-6);
    } else {
        REQUIRE((expected.nearest < round_off || until - t < 1e-9));
    }
    return true;
}

}  // namespace

TEST_CASE("ten thousand random flights meet the plate where marching meets it, none missed or doubled") {
    scene::RandomStream random(5);
    int met = 0;
    for (int trial = 0; trial < 10000; ++trial) {
        const auto plate =
            scene::PlateMotion::from_acceleration(std::exp(random.uniform(-2.0, 2.5)), random.uniform(0.05, 0.5));
        const double now = random.uniform(0.0, plate.period());
        // Half leave the plate, slowly or fast, as after a bounce; half come from above.
        const bool bounced = trial % 2 == 0;
        const double height = plate.position(now) + (bounced ? 0.0 : random.uniform(0.0, 10.0));
        const double relative = bounced ? std::exp(random.uniform(-8.0, 2.0)) : 3.0 * random.normal();
        met += agree({plate, height, plate.velocity(now) + relative, now}, plate.period());
    }
    CHECK(met > 3000);
}

TEST_CASE("a run of one particle bounces where marching says, flight by flight, over frames and cycles") {
    scene::Scene scene;
    scene.number_of_particles = 1;
    scene.box = {4.0, 4.0, 1e6};
    const double restitution = GENERATE(1.0, 0.9, 0.7, 0.5);
    scene.particles.restitution = scene::RestitutionConstant{restitution};
    scene.motion = scene::PlateMotion::from_acceleration(3.0, 0.2);
    md::Snapshot start;
    start.position = {{1.0, 1.0, 4.0}};
    start.velocity = {{0.1, 0.0, 0.0}};
    md::Simulation simulation(scene, start);
    const double period = scene.motion.period();
    double now = 0.0;
    int flights = 0;
    while (simulation.cycle() < 2000 && flights < 500) {
        const md::Snapshot state = simulation.snapshot();
        const Flight flight{scene.motion, state.position[0][2] - 0.5, state.velocity[0][2], now};
        const md::ContactEvent event = simulation.advance_contact();
        const double met = event.time_in_cycle + static_cast<double>(event.cycle - state.cycle) * period;
        if (met - now > 1e-3) {  // hops of the cut-off are known no better than round-off over their speed
            const Marched expected = march(flight, met + 0.1 * period);
            INFO("flight at " << flight.velocity << " from " << now << " of cycle " << state.cycle << " met " << met
                              << ", marched " << expected.time);
            REQUIRE(expected.time != md::never);
            // Round-off of heights reached in this flight, some five hundred additions of it, over the speed at the
            // contact.
            const double highest = 10.0 + 0.5 * flight.velocity * flight.velocity;
            const double closing = -static_cast<double>(flight.rate(expected.time));
            REQUIRE(std::abs(met - expected.time) < std::min(1e-6, 1e-13 * highest / closing + 1e-12));
            ++flights;
        }
        now = event.time_in_cycle;
    }
    CHECK(flights >= 100);
}

TEST_CASE("flights that graze the plate are decided by the sign of their closest gap") {
    scene::RandomStream random(6);
    for (int trial = 0; trial < 3000; ++trial) {
        const double acceleration = random.uniform(1.2, 6.0);
        const auto plate = scene::PlateMotion::from_acceleration(acceleration, random.uniform(0.1, 0.4));
        // Where the plate falls faster than gravity the gap has a minimum: put it at this time and this depth.
        const double half_width = std::acos(1.0 / acceleration);
        const double graze = (std::acos(-1.0) + random.uniform(-0.9, 0.9) * half_width) / plate.angular_frequency();
        const double depth = (trial % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, random.uniform(-12.0, -2.0));
        const double before = random.uniform(0.0, 0.3) * half_width / plate.angular_frequency();
        const double velocity = plate.velocity(graze) + before,
                     height = plate.position(graze) + depth - before * (velocity - 0.5 * before);
        const double now = graze - before;
        if (height < plate.position(now)) continue;
        const Flight flight{plate, height, velocity, now};
        agree(flight, plate.period());
        const double t = md::plate_contact_time(plate, height, velocity, now, graze);
        if (depth > 1e-11) CHECK(t == md::never);
        if (depth < -1e-11) CHECK(t <= graze);
    }
}

TEST_CASE("in contact and falling is now, in contact and rising is the next fall") {
    const auto plate = scene::PlateMotion::from_acceleration(3.0, 0.095);
    const double now = 1.0, height = plate.position(now);
    CHECK(md::plate_contact_time(plate, height, plate.velocity(now) - 0.1, now, 5.0) == now);
    CHECK(md::plate_contact_time(plate, height - 1e-13, plate.velocity(now) - 0.1, now, 5.0) == now);
    const double later = md::plate_contact_time(plate, height - 1e-13, plate.velocity(now) + 0.1, now, 5.0);
    CHECK(later > now + 0.01);
    CHECK(later < 5.0);
}

TEST_CASE("a particle riding on the plate makes finitely many hops and leaves where theory says") {
    // A body in contact leaves when the plate falls faster than gravity: cos 2 pi f t = -1/Gamma, that is
    // sin(2 pi f t0) = 1/Gamma with t0 from the plate's middle.
    const auto plate = scene::PlateMotion::from_acceleration(3.0, 0.095);
    double now = 0.3 * plate.period() * 0.5, velocity = plate.velocity(now), height = plate.position(now);
    constexpr double hop = 1e-4;
    int hops = 0;
    while (true) {
        const double t = md::plate_contact_time(plate, height, velocity, now, plate.period());
        if (t == md::never || t - now > 1.0) break;
        now = t;
        height = plate.position(t);
        velocity = plate.velocity(t) + hop;
        REQUIRE(++hops < 100000);
    }
    const double leaves = std::acos(-1.0 / 3.0) / plate.angular_frequency();
    // The last hops grow longer as the gap's acceleration vanishes: duration ~ (hop / its rate of change)^(1/2).
    CHECK(now == Approx(leaves).margin(0.05));
    CHECK(now < leaves);
}
