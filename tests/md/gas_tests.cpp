// SPDX-License-Identifier: MIT
// A periodic gas: conservation, no overlap, and inelastic collapse, which must not stall without a word.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "md/errors.hpp"
#include "small_systems.hpp"

using namespace shaken;

TEST_CASE("an elastic gas keeps its energy and its momentum") {
    const double fraction = GENERATE(0.05, 0.3, 0.5);
    md::Simulation simulation(small::gas(256, fraction));
    const double before = simulation.ledger().kinetic;
    simulation.advance_collisions(200000);
    const md::Ledger after = simulation.ledger();
    CHECK(std::abs(after.kinetic / before - 1.0) < 1e-12);  // round-off of 4e5 velocity changes, of either sign
    for (const double component : after.momentum) CHECK(std::abs(component) < 1e-11);
    CHECK(after.collision_loss == 0.0);
}

TEST_CASE("no two particles overlap after a million collisions") {
    md::Simulation simulation(small::gas(500, 0.45));
    for (int part = 0; part < 10; ++part) {
        simulation.advance_collisions(100000);
        CHECK(simulation.audit().largest_overlap < 1e-12);
    }
    CHECK(simulation.counters().deepest_contact < 1e-12);
    CHECK(simulation.counters().pair_collisions == 1000000);
}

TEST_CASE("an inelastic gas loses what its ledger says") {
    md::Simulation simulation(small::gas(1000, 0.1, 0.9));
    const double before = simulation.ledger().kinetic;
    simulation.advance_collisions(50000);
    const md::Ledger after = simulation.ledger();
    CHECK(after.kinetic < 0.5 * before);
    CHECK(std::abs(after.kinetic + after.collision_loss - before) < 1e-12 * before);  // round-off
}

TEST_CASE("inelastic collapse ends the run with the pair, the time and the remedy") {
    md::Simulation simulation(small::gas(500, 0.5, 0.1));
    try {
        simulation.advance_collisions(20000000);
        FAIL("no collapse");
    } catch (const md::Stalled& stalled) {
        const std::string what = stalled.what();
        INFO(what);
        CHECK(what.find("particles ") != std::string::npos);
        CHECK(what.find("t = ") != std::string::npos);
        CHECK(what.find("particles.restitution") != std::string::npos);
    }
}

TEST_CASE("a deep layer of constant restitution 0.6 collapses, one of 0.8 or of e(v) does not") {
    auto scene = small::layer(420);  // ten a unit area, as in chapter 4
    scene.box.x = 6.4;               // not whole diameters, in which a full row of touching spheres has no free path
    scene.box.y = 6.6;
    scene.motion = scene::PlateMotion::from_acceleration(3.0, 0.095);
    scene.particles.restitution = scene::RestitutionConstant{0.6};
    md::Simulation collapsing(scene);
    CHECK_THROWS_AS(collapsing.advance_to(1, 0.0), md::Stalled);
    CHECK(collapsing.cycle() == 0);  // at the first impact
    for (const scene::Restitution law : {scene::Restitution(scene::RestitutionConstant{0.8}),
                                         scene::Restitution(scene::RestitutionVelocity{0.7, 1.0})}) {
        scene.particles.restitution = law;
        md::Simulation flowing(scene);
        CHECK_NOTHROW(flowing.advance_to(12, 0.0));
    }
}

TEST_CASE("memory stays below 300 bytes a particle") {
    const md::Simulation small_one(small::gas(4000, 0.3)), large(small::gas(16000, 0.3));
    CHECK(static_cast<double>(large.memory() - small_one.memory()) / 12000.0 < 300.0);
}
