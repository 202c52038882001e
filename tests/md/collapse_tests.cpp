// SPDX-License-Identifier: MIT
// The remedies against inelastic collapse: each lets a layer run that collapses without, and changes little where
// nothing collapses.
#include <catch2/catch.hpp>
#include <cmath>

#include "md/contact_law.hpp"
#include "md/errors.hpp"
#include "small_systems.hpp"

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
    auto scene = deep_layer(0.6);
    CHECK_THROWS_AS(md::Simulation(scene).advance_to(2, 0.0), md::Stalled);
    scene.particles.collapse = GENERATE(scene::CollapseRemedy::elastic_below, scene::CollapseRemedy::contact_time);
    scene.particles.collapse_speed = 0.1;
    scene.particles.collapse_time = 1e-3;
    md::Simulation simulation(scene);
    CHECK_NOTHROW(simulation.advance_to(4, 0.0));
    CHECK(simulation.counters().pair_collisions < 4 * 420 * 2000);
    CHECK(simulation.ledger().collision_loss > 0.0);
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
