// SPDX-License-Identifier: MIT
// Inelastic collapse ends a run, and nothing else does; the remedies against it each let a layer run that collapses
// without, and change little where nothing collapses.
#include <cmath>
#include <string>

#include "md/contact_law.hpp"
#include "md/errors.hpp"
#include "md/parameters.hpp"
#include "small_systems.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

scene::Scene deep_layer(double restitution) {
    auto scene = small::layer(420);  // ten a unit area, as in chapter 4
    scene.box.x = 6.4;               // not whole diameters, in which a full row of touching spheres has no free path
    scene.box.y = 6.6;
    scene.motion = scene::PlateMotion::from_acceleration(3.0, 0.095);
    scene.particles.restitution = scene::RestitutionConstant{restitution};
    return scene;
}

}  // namespace

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

TEST_CASE("deep layers of constant restitution 0.5 collapse at the first impact, whatever the seed") {
    auto scene = deep_layer(0.5);
    scene.md.seed = GENERATE(range(1, 6));
    md::Simulation simulation(scene);
    CHECK_THROWS_WITH(simulation.advance_to(1, 0.0), Contains("inelastic collapse in cycle 0"));
}

TEST_CASE("deep and shallow layers of restitution 0.8, 0.9 or e(v) do not collapse, whatever the seed") {
    const scene::Restitution law = GENERATE(scene::Restitution(scene::RestitutionConstant{0.8}),
                                            scene::Restitution(scene::RestitutionConstant{0.9}),
                                            scene::Restitution(scene::RestitutionVelocity{0.7, 1.0}));
    auto scene = deep_layer(0.9);
    scene.particles.restitution = law;
    scene.number_of_particles = GENERATE(60, 420);
    for (scene.md.seed = 1; scene.md.seed <= 4; ++scene.md.seed) {
        md::Simulation simulation(scene);
        CHECK_NOTHROW(simulation.advance_to(3, 0.0));
    }
}

TEST_CASE("rows of touching spheres under e(v) slow a run down and are no collapse", "[slow]") {
    // Sides of whole diameters: a full row has no free path, contacts are a thousand times as frequent as elsewhere.
    auto scene = deep_layer(0.9);
    scene.box.x = 6.0;
    scene.box.y = 7.0;
    scene.particles.restitution = scene::RestitutionVelocity{0.7, 1.0};
    for (scene.md.seed = 1; scene.md.seed <= 3; ++scene.md.seed) {
        md::Simulation simulation(scene);
        CHECK_NOTHROW(simulation.advance_to(10, 0.0));
    }
}

TEST_CASE("the layer of chapter 4 collapses at constant restitution 0.6 and not at 0.7", "[slow]") {
    auto scene = md::read_scene(SHAKEN_SOURCE_DIR "/data/scenes/ch4_shock.toml", {"particles.restitution=0.6"});
    scene.md.seed = GENERATE(1, 2, 3);
    md::Simulation collapsing(scene);
    CHECK_THROWS_WITH(collapsing.advance_to(12, 0.0), Contains("inelastic collapse"));
    scene.particles.restitution = scene::RestitutionConstant{0.7};
    md::Simulation flowing(scene);
    CHECK_NOTHROW(flowing.advance_to(4, 0.0));
}

TEST_CASE("slow contacts, or those that follow another at once, are elastic where a remedy says so") {
    using Remedied = md::ContactLaw<scene::RestitutionConstant, false, true>;
    const Remedied slow{{0.6}, {}, {0.01, 0.0}}, soon{{0.6}, {}, {0.0, 1e-4}};
    CHECK(slow(0.009, 0.0) == 1.0);
    CHECK(slow(0.011, 0.0) == 0.6);
    CHECK(soon(1e-9, 1e-3) == 0.6);
    CHECK(soon(5.0, 0.9e-4) == 1.0);
    const md::ContactLaw<scene::RestitutionConstant, false, false> none{{0.6}, {}, {0.01, 1e-4}};
    CHECK(none(0.0, 0.0) == 0.6);
}

TEST_CASE("a layer that collapses runs with either remedy") {
    auto scene = deep_layer(0.5);
    CHECK_THROWS_AS(md::Simulation(scene).advance_to(1, 0.0), md::Stalled);
    scene.particles.collapse = GENERATE(scene::CollapseRemedy::elastic_below, scene::CollapseRemedy::contact_time);
    scene.particles.collapse_speed = 0.1;
    scene.particles.collapse_time = 1e-3;
    md::Simulation simulation(scene);
    CHECK_NOTHROW(simulation.advance_to(4, 0.0));
    CHECK(simulation.counters().pair_collisions < 4 * 420 * 2000);
    const md::Ledger books = simulation.ledger();
    CHECK(books.collision_loss > 0.5 * books.plate_work);  // it dissipates as grains of 0.5 do, but for slow contacts
}

TEST_CASE("where nothing collapses a short contact time changes no statistics") {
    md::UniformSystem system = small::gas(1000, 0.2, 0.9);
    const auto cooled = [&] {
        md::Simulation simulation(system);
        simulation.advance_collisions(20000);
        return simulation.ledger().kinetic / 1500.0;
    };
    const double without = cooled();
    system.collapse = scene::CollapseRemedy::contact_time;
    system.collapse_time = 1e-5;  // times the contact rate of 5: one contact in ten thousand is made elastic
    // 20 collisions of each of 1000 particles: the relative scatter of T is about (20 / 1000)^(1/2) (1 - e^2) / 2.
    CHECK(cooled() == Approx(without).epsilon(0.05));
}
