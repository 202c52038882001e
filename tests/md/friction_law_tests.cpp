// SPDX-License-Identifier: MIT
// Walton's friction: the published collisions, what each contact keeps, and a shaken frictional layer's ledger.
#include <cmath>

#include "files/checkpoint.hpp"
#include "md/collision_law.hpp"
#include "md/friction_law.hpp"
#include "scene/random_stream.hpp"
#include "small_systems.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;
using md::Vector3;

namespace {

Vector3 random_vector(scene::RandomStream& random) { return {random.normal(), random.normal(), random.normal()}; }

double energy(const Vector3& v, const Vector3& w) {
    return 0.5 * md::dot(v, v) + 0.125 * md::sphere_inertia * md::dot(w, w);
}

struct Body {
    Vector3 v{}, w{};
};

/// The whole contact, normal and tangential; returns the loss that the law states.
double collide(Body& a, Body& b, const Vector3& n, double e, const md::WaltonFriction& friction, md::Partner partner) {
    Vector3 v, spins;
    for (std::size_t k = 0; k < 3; ++k) {
        v[k] = a.v[k] - b.v[k];
        spins[k] = a.w[k] + b.w[k];
    }
    const double approach = md::dot(v, n), share = partner == md::Partner::wall ? 2.0 : 1.0;
    const auto rub = md::collide_tangentially(n, v, spins, e, friction, partner);
    for (std::size_t k = 0; k < 3; ++k) {
        const double gain = rub.velocity[k] - share * 0.5 * (1.0 + e) * approach * n[k];
        a.v[k] += gain;
        a.w[k] += rub.spin[k];
        if (partner == md::Partner::wall) continue;
        b.v[k] -= gain;
        b.w[k] += rub.spin[k];
    }
    return rub.loss + share * 0.25 * (1.0 - e * e) * approach * approach;
}

double balance(const md::Ledger& l) {
    return l.kinetic + l.rotational + l.potential - l.plate_work - l.ceiling_work + l.collision_loss + l.plate_loss +
           l.ceiling_loss;
}

scene::Scene frictional_layer(scene::FrictionLaw law) {
    auto scene = small::layer(150, scene::RestitutionVelocity{0.7, 1.0});
    scene.box.ceiling = 12.0;  // low enough to be hit
    scene.initial.temperature = 6.0;
    scene.particles.friction = {law, 0.35, 0.5};
    return scene;
}

}  // namespace

TEST_CASE("Walton's sticking and sliding collisions are those worked out by hand") {
    // e = 0.7, beta0 = 0.35, mu = 0.5, n along x, b at rest; eight digits are given.
    const md::WaltonFriction friction{0.35, 0.5};
    Body a{{2.0, 0.3, 0.0}, {}}, b;
    double loss = collide(a, b, {1.0, 0.0, 0.0}, 0.7, friction, md::Partner::sphere);
    CHECK(a.v[0] == Approx(0.3).margin(1e-8));
    CHECK(a.v[1] == Approx(0.24214286).margin(1e-8));
    CHECK(a.w[2] == Approx(-0.28928571).margin(1e-8));
    CHECK(b.w[2] == a.w[2]);
    CHECK(loss == Approx(0.51564107).margin(1e-8));
    a = {{0.2, 3.0, 0.0}, {}};
    b = {};
    loss = collide(a, b, {1.0, 0.0, 0.0}, 0.7, friction, md::Partner::sphere);
    CHECK(a.v[0] == Approx(0.03).margin(1e-8));
    CHECK(a.v[1] == Approx(2.915).margin(1e-8));
    CHECK(a.w[2] == Approx(-0.425).margin(1e-8));
    CHECK(b.w[2] == a.w[2]);
    CHECK(loss == Approx(0.2348125).margin(1e-8));
}

TEST_CASE("against a wall both changes are twice those against a sphere") {
    const md::WaltonFriction friction{0.35, 0.5};
    Body a{{2.0, 0.3, 0.0}, {}}, wall;
    collide(a, wall, {1.0, 0.0, 0.0}, 0.7, friction, md::Partner::wall);
    CHECK(a.v[0] == Approx(2.0 - 2 * 1.7).margin(1e-8));
    CHECK(a.v[1] == Approx(0.3 - 2 * (0.3 - 0.24214286)).margin(2e-8));  // eight digits, doubled
    CHECK(a.w[2] == Approx(-2 * 0.28928571).margin(2e-8));
}

TEST_CASE("a frictional contact keeps momentum and angular momentum, reverses the slip by beta, loses what it says") {
    const double per_inertia = GENERATE(2.5, 0.0);
    const md::WaltonFriction friction{0.35, 0.5, per_inertia};
    const auto partner = GENERATE(md::Partner::sphere, md::Partner::wall);
    scene::RandomStream random(5);
    int sticking = 0, sliding = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        Vector3 n = random_vector(random);
        const double length = std::sqrt(md::dot(n, n));
        for (double& c : n) c /= length;
        Body a{random_vector(random), {}}, b{random_vector(random), {}};
        if (per_inertia > 0.0) a.w = random_vector(random);
        if (partner == md::Partner::wall)
            b.w = {};
        else if (per_inertia > 0.0)
            b.w = random_vector(random);
        const auto slip = [&] {
            Vector3 v, spins;
            for (std::size_t k = 0; k < 3; ++k) {
                v[k] = a.v[k] - b.v[k];
                spins[k] = a.w[k] + b.w[k];
            }
            const Vector3 turning = md::cross(spins, n);
            const double normal = md::dot(v, n);
            for (std::size_t k = 0; k < 3; ++k) v[k] += 0.5 * turning[k] - normal * n[k];
            return v;
        };
        // Orbital part about the midpoint, a at -n/2 and b at n/2, and I = K/4.
        const auto angular = [&] {
            const Vector3 orbit = md::cross(n, {b.v[0] - a.v[0], b.v[1] - a.v[1], b.v[2] - a.v[2]});
            Vector3 sum;
            for (std::size_t k = 0; k < 3; ++k) sum[k] = 0.5 * orbit[k] + 0.25 * md::sphere_inertia * (a.w[k] + b.w[k]);
            return sum;
        };
        const Body a0 = a, b0 = b;
        const Vector3 slip_before = slip(), angular_before = angular();
        const double before = energy(a.v, a.w) + energy(b.v, b.w);
        const Vector3 in_wall{a.v[0] - b.v[0], a.v[1] - b.v[1], a.v[2] - b.v[2]};
        const double before_in_wall = energy(in_wall, a.w);
        const double e = random.uniform();
        const double loss = collide(a, b, n, e, friction, partner);
        const Vector3 slip_after = slip();
        const double ratio = -md::dot(slip_after, slip_before) / md::dot(slip_before, slip_before);
        CHECK(ratio <= 0.35 + 1e-12);  // round-off
        (ratio > 0.35 - 1e-9 ? sticking : sliding)++;
        for (std::size_t k = 0; k < 3; ++k)  // round-off of some fifty operations, over a slip that may be small
            CHECK(slip_after[k] == Approx(-ratio * slip_before[k]).margin(1e-12));
        const double round_off = 1e-13 * (1.0 + before);
        if (partner == md::Partner::wall) {
            const Vector3 after{a.v[0] - b.v[0], a.v[1] - b.v[1], a.v[2] - b.v[2]};
            CHECK(before_in_wall - energy(after, a.w) == Approx(loss).margin(round_off));
        } else {
            CHECK(before - energy(a.v, a.w) - energy(b.v, b.w) == Approx(loss).margin(round_off));
            for (std::size_t k = 0; k < 3; ++k) {
                CHECK(a.v[k] + b.v[k] == Approx(a0.v[k] + b0.v[k]).margin(round_off));
                if (per_inertia > 0.0) CHECK(angular()[k] == Approx(angular_before[k]).margin(round_off));
            }
        }
        if (per_inertia == 0.0) CHECK(a.w == Vector3{});
    }
    CHECK(sticking > 100);
    CHECK(sliding > 100);
}

TEST_CASE("the energy ledger of a frictional layer closes, and it is the spins that take part") {
    const auto law = GENERATE(scene::FrictionLaw::walton, scene::FrictionLaw::walton_without_spin);
    md::Simulation simulation(frictional_layer(law));
    const double initial = balance(simulation.ledger());
    simulation.advance_to(15, 0.0);
    const md::Ledger l = simulation.ledger();
    // Round-off of some 10^6 additions, of either sign.
    CHECK(std::abs(balance(l) - initial) < 1e-12 * (l.collision_loss + l.plate_work + initial));
    const bool spins = law == scene::FrictionLaw::walton;
    CHECK((l.rotational > 0.01 * l.kinetic) == spins);
    CHECK(simulation.snapshot().spin.size() == (spins ? 150u : 0u));
    CHECK(simulation.counters().ceiling_collisions > 0);
    CHECK(simulation.counters().deepest_contact < 1e-12);
}

TEST_CASE("friction without friction is the smooth layer") {
    auto scene = frictional_layer(scene::FrictionLaw::walton);
    scene.particles.friction.mu = 0.0;  // beta = -1: no tangential impulse
    auto smooth = scene;
    smooth.particles.friction = {};
    md::Simulation one(scene), other(smooth);
    const double until = 0.04 * one.plate_period();  // before chaos has amplified the round-off
    one.advance_to(0, until);
    other.advance_to(0, until);
    CHECK(one.counters().pair_collisions > 50);
    CHECK(one.counters().pair_collisions == other.counters().pair_collisions);
    CHECK(one.ledger().kinetic == Approx(other.ledger().kinetic).epsilon(1e-12));
    CHECK(one.ledger().rotational < 1e-25);
}

TEST_CASE("a frictional or remedied run restored from a checkpoint goes on with the same bits") {
    auto scene = frictional_layer(GENERATE(scene::FrictionLaw::none, scene::FrictionLaw::walton));
    scene.particles.collapse = scene::CollapseRemedy::contact_time;
    scene.particles.collapse_time = 1e-2;
    const support::TemporaryFolder folder;
    md::Simulation straight(scene), first(scene), second(scene);
    straight.advance_to(3, 0.5);
    first.advance_to(1, 2.2);
    files::CheckpointWriter out;
    first.save(out);
    out.commit(folder.path() / "state");
    second.restore(files::CheckpointReader(folder.path() / "state"));
    second.advance_to(3, 0.5);
    CHECK(second.state_hash() == straight.state_hash());
}
