// SPDX-License-Identifier: MIT
// One contact at a time: which way friction turns and pushes at plate, ceiling and partner, and whose last contact the
// remedy against collapse looks at. Expected from the velocity of the two surfaces where they touch, not from the law's
// own formulas.
#include <cmath>

#include "md/friction_law.hpp"
#include "small_systems.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

using Vector = std::array<double, 3>;
constexpr double inertia = 0.1;      // 2/5 m (sigma/2)^2 of a uniform sphere
constexpr double round_off = 1e-13;  // of a contact time and some twenty operations on numbers of order one

/// The frame takes the layer's mean velocity out and puts it back: what it costs is round-off.
md::Simulation of(const scene::Scene& scene, std::vector<Vector> position, std::vector<Vector> velocity,
                  std::vector<Vector> spin = {}, double time = 0.0) {
    return {scene, md::Snapshot{0, time, std::move(position), std::move(velocity), std::move(spin)}};
}

scene::Scene rough(double mu) {
    auto scene = small::layer(1, scene::RestitutionConstant{0.8});
    scene.particles.friction = {scene::FrictionLaw::walton, 0.35, mu};
    return scene;
}

}  // namespace

TEST_CASE("a sphere that spins is pushed by the plate and by the ceiling against the motion of its surface there") {
    const bool on_plate = GENERATE(true, false);
    const double below = on_plate ? -0.5 : 0.5;  // from the centre to the point of contact
    const auto scene = rough(10.0);              // sticks
    const Vector spin{0.7, -1.1, 0.4}, velocity{0.3, 0.2, on_plate ? -2.0 : 2.0};
    auto simulation = of(scene, {{1.0, 1.0, on_plate ? 0.6 : scene.box.ceiling - 0.6}}, {velocity}, {spin});
    REQUIRE(simulation.advance_contact().kind ==
            (on_plate ? md::ContactEvent::Kind::plate : md::ContactEvent::Kind::ceiling));
    const auto after = simulation.snapshot();
    const Vector &v = after.velocity[0], &w = after.spin[0];
    // Velocity of the surface that touches, u + w x (0, 0, below): reversed by beta0.
    CHECK(v[0] + w[1] * below == Approx(-0.35 * (velocity[0] + spin[1] * below)).margin(round_off));
    CHECK(v[1] - w[0] * below == Approx(-0.35 * (velocity[1] - spin[0] * below)).margin(round_off));
    // What pushes at that point turns by its arm: I dw = (0, 0, below) x dv.
    CHECK(inertia * (w[0] - spin[0]) == Approx(-below * (v[1] - velocity[1])).margin(round_off));
    CHECK(inertia * (w[1] - spin[1]) == Approx(below * (v[0] - velocity[0])).margin(round_off));
    CHECK(w[2] == spin[2]);  // no couple about the normal
}

TEST_CASE("a sphere that slides is pushed by mu times what the moving plate gives along the normal") {
    const auto scene = rough(0.1);
    const double started = 0.1 / scene.motion.frequency;  // the plate rises
    const double floor = scene.motion.position(started);
    auto simulation = of(scene, {{1.0, 1.0, floor + 0.6}}, {{0.0, 5.0, -2.0}}, {}, started);
    REQUIRE(simulation.advance_contact().kind == md::ContactEvent::Kind::plate);
    const auto after = simulation.snapshot();
    const double fallen = -2.0 - (after.time_in_cycle - started), plate = scene.motion.velocity(after.time_in_cycle);
    REQUIRE(plate > 0.1);
    CHECK(after.velocity[0][2] - plate == Approx(-0.8 * (fallen - plate)).epsilon(1e-12));
    CHECK(after.velocity[0][1] - 5.0 == Approx(-0.1 * (after.velocity[0][2] - fallen)).epsilon(1e-12));
}

TEST_CASE("spheres that spin rub against the motion of their surfaces, and share the spin they gain") {
    auto scene = rough(10.0);
    scene.number_of_particles = 2;
    const Vector left{1.0, 0.2, 0.1}, right{-1.0, -0.3, 0.4}, spin_left{0.2, 0.9, -0.5}, spin_right{-0.4, 0.3, 1.3};
    const bool turned = GENERATE(false, true);  // whichever has the lower number
    auto simulation = turned ? of(scene, {{3.0, 2.0, 20.0}, {1.8, 2.0, 20.0}}, {right, left}, {spin_right, spin_left})
                             : of(scene, {{1.8, 2.0, 20.0}, {3.0, 2.0, 20.0}}, {left, right}, {spin_left, spin_right});
    const Vector free_fall{0.0, 0.0, -1.0};
    REQUIRE(simulation.advance_contact().kind == md::ContactEvent::Kind::pair);
    const auto after = simulation.snapshot();
    const std::size_t l = turned ? 1 : 0, r = 1 - l;
    Vector n, before_left = left, before_right = right, gained_left, gained_right, turn_left, turn_right;
    for (std::size_t k = 0; k < 3; ++k) {
        n[k] = after.position[r][k] - after.position[l][k];
        before_left[k] += free_fall[k] * after.time_in_cycle;
        before_right[k] += free_fall[k] * after.time_in_cycle;
        gained_left[k] = after.velocity[l][k] - before_left[k];
        gained_right[k] = after.velocity[r][k] - before_right[k];
        turn_left[k] = after.spin[l][k] - spin_left[k];
        turn_right[k] = after.spin[r][k] - spin_right[k];
    }
    // Each centre lies half of n from the point of contact.
    const auto slip = [&](const Vector& a, const Vector& b, const Vector& wa, const Vector& wb) {
        const Vector turning = md::cross({wa[0] + wb[0], wa[1] + wb[1], wa[2] + wb[2]}, n);
        Vector s;
        for (std::size_t k = 0; k < 3; ++k) s[k] = a[k] - b[k] + 0.5 * turning[k];
        const double along = md::dot(s, n);
        for (std::size_t k = 0; k < 3; ++k) s[k] -= along * n[k];
        return s;
    };
    const Vector was = slip(before_left, before_right, spin_left, spin_right),
                 is = slip(after.velocity[l], after.velocity[r], after.spin[l], after.spin[r]);
    const Vector torque = md::cross(n, gained_left);  // twice it: the arm is n/2
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(is[k] == Approx(-0.35 * was[k]).margin(10 * round_off));  // of the distance, which is 1 to 1e-14
        CHECK(gained_right[k] == Approx(-gained_left[k]).margin(round_off));
        CHECK(inertia * turn_left[k] == Approx(0.5 * torque[k]).margin(round_off));
        CHECK(turn_right[k] == Approx(turn_left[k]).margin(round_off));
    }
}

TEST_CASE("a contact is elastic where either partner has just met another, also across the end of a cycle") {
    auto scene = small::layer(3, scene::RestitutionConstant{0.5});
    scene.particles.collapse = scene::CollapseRemedy::contact_time;
    const bool soon = GENERATE(true, false);
    scene.particles.collapse_time = soon ? 0.05 : 0.03;
    const bool turned = GENERATE(false, true);  // whichever has the lower number
    const double period = scene.motion.period();
    const double started = GENERATE(0.0, 0.95, 0.976, 0.985) * period;  // of 5: 0.976 ends between the two contacts
    // The first meets the second after 0.1, which goes on at 3/4 and meets the third 0.04 later.
    const double second = 2.1, third = second + 1.0 + 0.75 * 0.04;
    std::vector<Vector> position{{1.0, 2.0, 30.0}, {second, 2.0, 30.0}, {third, 2.0, 30.0}},
        velocity{{1.0, 0.0, 0.0}, {}, {}};
    if (turned) {
        std::swap(position[0], position[2]);
        std::swap(velocity[0], velocity[2]);
    }
    auto simulation = of(scene, position, velocity, {}, started);
    simulation.advance_contact();
    const double loss = simulation.ledger().collision_loss;
    CHECK(loss == Approx(0.25 * 0.75).epsilon(1e-12));  // (m/4) (1 - e^2) v^2
    const auto contact = simulation.advance_contact();
    REQUIRE(contact.first != (turned ? 2 : 0));
    REQUIRE(contact.second != (turned ? 2 : 0));
    CHECK(simulation.ledger().collision_loss - loss == Approx(soon ? 0.0 : 0.25 * 0.75 * 0.75 * 0.75).margin(1e-12));
}
