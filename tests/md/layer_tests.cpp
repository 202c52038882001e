// SPDX-License-Identifier: MIT
// A small shaken layer: what is conserved, what is reproducible, what is refused.
#include <cmath>
#include <numbers>

#include "files/checkpoint.hpp"
#include "files/errors.hpp"
#include "md/errors.hpp"
#include "small_systems.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

namespace {

double balance(const md::Ledger& ledger) {
    return ledger.kinetic + ledger.potential - ledger.plate_work - ledger.ceiling_work + ledger.collision_loss +
           ledger.plate_loss + ledger.ceiling_loss;
}

}  // namespace

TEST_CASE("the energy ledger of a shaken layer closes") {
    const scene::Restitution law = GENERATE(scene::Restitution(scene::RestitutionConstant{0.9}),
                                            scene::Restitution(scene::RestitutionVelocity{0.7, 1.0}));
    md::Simulation simulation(small::layer(150, law));
    const double initial = balance(simulation.ledger());
    for (int cycle = 1; cycle <= 30; ++cycle) {
        simulation.advance_to(cycle, 0.0);
        const md::Ledger ledger = simulation.ledger();
        // Round-off of some 10^6 additions, of either sign.
        REQUIRE(std::abs(balance(ledger) - initial) < 1e-12 * (ledger.collision_loss + ledger.plate_work + initial));
    }
    const md::Ledger ledger = simulation.ledger();
    CHECK(ledger.collision_loss > 10.0 * ledger.kinetic);  // the shaking, not the start, is what is balanced
    CHECK(ledger.plate_work > 0.5 * (ledger.collision_loss + ledger.plate_loss));  // the plate pays, the start does not
    // No horizontal force acts: the start's zero stays, but for round-off of 10^5 collisions.
    CHECK(std::abs(ledger.momentum[0]) < 1e-10);
    CHECK(std::abs(ledger.momentum[1]) < 1e-10);
    const md::Counters counters = simulation.counters();
    CHECK(counters.pair_collisions > 50000);
    CHECK(counters.plate_collisions > 5000);
    CHECK(counters.deepest_contact < 1e-12);
    const md::Audit audit = simulation.audit();
    CHECK(audit.largest_overlap < 1e-12);
    CHECK(audit.deepest_in_plate < 1e-12);
}

TEST_CASE("the plate's impulse less the weight is the change of momentum") {
    md::Simulation simulation(small::layer());
    simulation.advance_to(5, 0.3);
    const double elapsed = 5 * simulation.plate_period() + 0.3;
    const md::Ledger ledger = simulation.ledger();
    REQUIRE(simulation.counters().ceiling_collisions == 0);
    // Round-off of 10^4 additions to a sum of 4000.
    CHECK(ledger.momentum[2] == Approx(ledger.plate_impulse - 150 * elapsed).margin(1e-9));
}

TEST_CASE("the same seed gives the same bits, another seed another history") {
    auto scene = small::layer();
    md::Simulation one(scene), same(scene);
    scene.md.seed = 2;
    md::Simulation other(scene);
    for (md::Simulation* s : {&one, &same, &other}) s->advance_to(3, 1.0);
    CHECK(one.state_hash() == same.state_hash());
    CHECK(one.state_hash() != other.state_hash());
}

TEST_CASE("how often the run is interrupted and looked at does not change it") {
    md::Simulation straight(small::layer()), halting(small::layer()), counted(small::layer()), short_of(small::layer());
    const double period = straight.plate_period();
    straight.advance_to(4, 0.25 * period);
    for (int cycle = 0; cycle < 5; ++cycle)
        for (int sample = 0; sample < 37; ++sample) {
            const double t = sample * period / 37.0;
            if (cycle == 4 && t > 0.25 * period) break;
            halting.advance_to(cycle, t);
            REQUIRE(halting.cycle() == cycle);
            REQUIRE(halting.time_in_cycle() == t);
            CHECK(halting.snapshot().position.size() == 150);
            halting.ledger();
        }
    halting.advance_to(4, 0.25 * period);
    while (counted.cycle() < 4) counted.advance_contact();
    counted.advance_to(4, 0.25 * period);
    int halts = 0;
    while (!short_of.advance_to(4, 0.25 * period, 7)) ++halts;
    CHECK(halts > 100);
    CHECK(straight.state_hash() == halting.state_hash());
    CHECK(straight.state_hash() == counted.state_hash());
    CHECK(straight.state_hash() == short_of.state_hash());
    straight.advance_to(2, 0.0);  // past already: nothing happens
    CHECK(straight.state_hash() == halting.state_hash());
}

TEST_CASE("a run restored from a checkpoint goes on with the same bits, from any instant") {
    const auto law = GENERATE(scene::Restitution(scene::RestitutionConstant{0.9}),
                              scene::Restitution(scene::RestitutionVelocity{0.7, 1.0}));
    const auto scene = small::layer(150, law);
    const support::TemporaryFolder folder;
    md::Simulation straight(scene);
    const double period = straight.plate_period();
    straight.advance_to(5, 0.6 * period);
    for (const double when : {0.0, 0.031, 1.0, 2.77, 4.5}) {
        INFO("saved after " << when << " cycles");
        md::Simulation first(scene);
        const auto cycle = static_cast<std::int64_t>(when);
        first.advance_to(cycle, (when - static_cast<double>(cycle)) * period);
        files::CheckpointWriter out;
        first.save(out);
        out.commit(folder.path() / "state");
        md::Simulation second(scene);
        second.restore(files::CheckpointReader(folder.path() / "state"));
        CHECK(second.state_hash() == first.state_hash());
        second.advance_to(5, 0.6 * period);
        CHECK(second.state_hash() == straight.state_hash());
    }
}

TEST_CASE("a checkpoint of another system is refused") {
    const support::TemporaryFolder folder;
    files::CheckpointWriter out;
    md::Simulation(small::layer(150)).save(out);
    out.commit(folder.path() / "state");
    const files::CheckpointReader in(folder.path() / "state");
    md::Simulation fewer(small::layer(149));
    CHECK_THROWS_AS(fewer.restore(in), files::Damaged);
    auto wider = small::layer(150);
    wider.box.x = 6.5;
    md::Simulation elsewhere(wider);
    CHECK_THROWS_AS(elsewhere.restore(in), files::Damaged);
}

TEST_CASE("the knobs of the method change round-off, not what is computed") {
    // Chaos amplifies round-off by about e per collision of a particle: a fraction of a cycle is still comparable.
    md::Options options;
    options.shell = GENERATE(0.2, 0.6);
    options.frames_per_cycle = GENERATE(1, 40);
    md::Simulation usual(small::layer()), other(small::layer(), options);
    const double until = 0.04 * usual.plate_period();
    usual.advance_to(0, until);
    other.advance_to(0, until);
    const auto a = usual.snapshot(), b = other.snapshot();
    CHECK(usual.counters().pair_collisions > 50);
    CHECK(usual.counters().pair_collisions == other.counters().pair_collisions);
    for (std::size_t i = 0; i < a.position.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) CHECK(a.velocity[i][k] == Approx(b.velocity[i][k]).margin(1e-9));
}

TEST_CASE("starts that cannot be are refused") {
    auto narrow = small::layer(4);
    narrow.box.x = 2.0;
    CHECK_THROWS_AS(md::Simulation(narrow), md::CannotSetUp);
    md::Snapshot start;
    start.position = {{1.0, 1.0, 1.0}, {1.0, 1.0, 1.9}};
    start.velocity = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    CHECK_THROWS_AS(md::Simulation(small::layer(2), start), md::CannotSetUp);
    start.position[1][2] = 0.4;
    start.position[0][2] = 5.0;
    CHECK_THROWS_AS(md::Simulation(small::layer(2), start), md::CannotSetUp);
    start.position[1][2] = std::nan("");
    CHECK_THROWS_AS(md::Simulation(small::layer(2), start), md::InvariantBroken);
}

TEST_CASE(
    "a totally inelastic body leaves the plate at sin(2 pi f t0) = 1/Gamma and lands a whole number of periods on") {
    // Gamma = sqrt(1 + pi^2): the flight lasts exactly one period (reference: the plug of Mehta and Luck).
    const double gamma = std::sqrt(1.0 + M_PI * M_PI);
    auto scene = small::layer(1, scene::RestitutionConstant{0.0});
    scene.motion = scene::PlateMotion::from_acceleration(gamma, 0.1);
    md::Snapshot start;
    start.position = {{1.0, 1.0, 0.5}};
    start.velocity = {{0.0, 0.0, 0.0}};
    md::Simulation simulation(scene, start);
    // The plate's middle is passed upwards at a quarter of the period.
    const double leaves = (0.25 + std::asin(1.0 / gamma) / (2.0 * M_PI)) * 10.0;
    simulation.advance_to(0, 5.0);
    md::ContactEvent event;
    do {
        event = simulation.advance_contact();
        if (event.cycle == 0) REQUIRE(event.time_in_cycle < leaves + 0.1);
    } while (event.cycle == 0);
    // The cut-off: it rides by hops that leave the plate at 1e-4, so it leaves early by up to the root of a hop's size.
    CHECK(event.cycle == 1);
    CHECK(event.time_in_cycle == Approx(leaves).margin(0.05));
}

TEST_CASE("under the least ceiling that a scene may have a layer runs and no particle leaves the box") {
    auto scene = small::layer();
    const double thickness = scene.number_per_area() * (std::numbers::pi / 6.0) / scene.initial.volume_fraction;
    scene.box.ceiling = 2.0 * scene.motion.amplitude + thickness + 1.0;
    md::Simulation simulation(scene);
    for (int cycle = 0; cycle < 3; ++cycle)
        for (const double phase : {0.25, 0.5, 0.75}) {
            simulation.advance_to(cycle, phase * simulation.plate_period());
            const md::Audit audit = simulation.audit();
            CHECK(audit.largest_overlap < 1e-12);  // round-off of contact times
            CHECK(audit.deepest_in_plate < 1e-12);
            CHECK(audit.deepest_in_ceiling < 1e-12);
        }
    CHECK(simulation.counters().ceiling_collisions > 100);
}
