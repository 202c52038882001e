// SPDX-License-Identifier: MIT
// A periodic gas: conservation and no overlap.
#include <cmath>

#include "small_systems.hpp"
#include "tests/support/catch.hpp"

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

TEST_CASE("memory stays below 300 bytes a particle") {
    const md::Simulation small_one(small::gas(4000, 0.3)), large(small::gas(16000, 0.3));
    CHECK(static_cast<double>(large.memory() - small_one.memory()) / 12000.0 < 300.0);
}
