// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include "md/collision_law.hpp"
#include "scene/random_stream.hpp"
#include "scene/restitution.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector random_vector(scene::RandomStream& random) { return {random.normal(), random.normal(), random.normal()}; }

}  // namespace

TEST_CASE("a collision keeps momentum, reverses the normal velocity times e, and loses (m/4)(1-e^2)(g.n)^2") {
    const double e = GENERATE(0.0, 0.5, 0.9, 1.0);
    scene::RandomStream random(7);
    for (int trial = 0; trial < 1000; ++trial) {
        INFO("restitution " << e << ", trial " << trial);
        Vector n = random_vector(random);
        const double length = std::sqrt(dot(n, n));
        for (double& c : n) c /= length;
        Vector a = random_vector(random), b = random_vector(random);
        Vector v{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        if (dot(n, v) > 0.0) {
            std::swap(a, b);
            v = {-v[0], -v[1], -v[2]};
        }
        const double before = 0.5 * (dot(a, a) + dot(b, b)), approach = dot(n, v);
        const auto impulse = md::collide_pair(approach, dot(n, n), scene::RestitutionConstant{e});
        Vector a_after = a, b_after = b;
        for (std::size_t k = 0; k < 3; ++k) {
            a_after[k] += impulse.factor * n[k];
            b_after[k] -= impulse.factor * n[k];
        }
        const double after = 0.5 * (dot(a_after, a_after) + dot(b_after, b_after));
        const double round_off = 1e-14 * (1.0 + before);  // some fifty operations on numbers of this size
        CHECK(before - after == Approx(0.25 * (1 - e * e) * approach * approach).margin(round_off));
        CHECK(impulse.loss == Approx(before - after).margin(round_off));
        for (std::size_t k = 0; k < 3; ++k) CHECK(a_after[k] + b_after[k] == Approx(a[k] + b[k]).margin(round_off));
        const Vector w{b_after[0] - a_after[0], b_after[1] - a_after[1], b_after[2] - a_after[2]};
        CHECK(dot(n, w) == Approx(-e * approach).margin(round_off));
        for (std::size_t k = 0; k < 3; ++k)  // the tangential part is untouched
            CHECK(w[k] - dot(n, w) * n[k] == Approx(v[k] - approach * n[k]).margin(round_off));
    }
}

TEST_CASE("the velocity-dependent law gives slow collisions their restitution") {
    const scene::RestitutionVelocity law{0.7, 1.0};
    for (const double speed : {1e-6, 0.01, 0.5, 1.0, 8.0}) {
        const auto impulse = md::collide_pair(-speed, 1.0, law);
        const double after = -speed - 2.0 * impulse.factor;         // r.v of the pair, both partners moved
        CHECK(after == Approx(law(speed) * speed).epsilon(1e-12));  // round-off, amplified by 1 - e of a slow contact
    }
}

TEST_CASE("a moving wall's work less its loss is the gain of kinetic energy") {
    scene::RandomStream random(11);
    for (int trial = 0; trial < 1000; ++trial) {
        const double wall = random.normal(), velocity = wall - std::abs(random.normal());
        const double e = random.uniform();
        const auto impulse = md::collide_wall(velocity, wall, 1.0, scene::RestitutionConstant{e}, 0.0);
        CHECK(impulse.velocity - wall == Approx(-e * (velocity - wall)).margin(1e-14));
        const double gained = 0.5 * (impulse.velocity * impulse.velocity - velocity * velocity);
        CHECK(impulse.work - impulse.loss == Approx(gained).margin(1e-13));  // round-off of squares up to 10
        CHECK(impulse.loss == Approx(0.5 * (1 - e * e) * (velocity - wall) * (velocity - wall)).margin(1e-13));
    }
}

TEST_CASE("a wall above is a wall below seen upside down") {
    const auto above = md::collide_wall(3.0, 1.0, -1.0, scene::RestitutionConstant{0.5}, 0.0);
    const auto below = md::collide_wall(-3.0, -1.0, 1.0, scene::RestitutionConstant{0.5}, 0.0);
    CHECK(above.velocity == -below.velocity);
    CHECK(above.work == below.work);
    CHECK(above.loss == below.loss);
}

TEST_CASE("a rebound below the cut-off leaves the wall at the cut-off") {
    const auto impulse = md::collide_wall(2.0 - 1e-9, 2.0, 1.0, scene::RestitutionConstant{0.5}, 1e-4);
    CHECK(impulse.velocity == Approx(2.0 + 1e-4).epsilon(1e-14));
    CHECK(impulse.loss < 0.0);
    const auto resting = md::collide_wall(2.0, 2.0, 1.0, scene::RestitutionConstant{0.5}, 1e-4);
    CHECK(resting.velocity == Approx(2.0 + 1e-4).epsilon(1e-14));
}
