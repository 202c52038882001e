// SPDX-License-Identifier: MIT
#include <cmath>

#include "md/contact_time.hpp"
#include "scene/random_stream.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

/// For relative position (x, y, 0) and relative velocity (u, w, 0).
double contact(double x, double y, double u, double w) {
    return md::time_to_contact(x * u + y * w, x * x + y * y, u * u + w * w);
}

}  // namespace

TEST_CASE("two spheres meet head on after their gap over their speed") {
    CHECK(contact(3.0, 0.0, -4.0, 0.0) == 0.5);
    CHECK(contact(1.0 + 1e-9, 0.0, -1.0, 0.0) == Approx(1e-9).epsilon(1e-6));  // 1 + 1e-9 itself is rounded to 1e-7
}

TEST_CASE("spheres that recede or pass by never meet") {
    CHECK(contact(3.0, 0.0, 4.0, 0.0) == md::never);
    CHECK(contact(3.0, 1.0 + 1e-12, -1.0, 0.0) == md::never);
    CHECK(contact(3.0, 0.0, 0.0, 1.0) == md::never);
    CHECK(contact(3.0, 0.0, 0.0, 0.0) == md::never);
}

TEST_CASE("a grazing contact is found at the closest approach") {
    CHECK(contact(3.0, 1.0, -1.0, 0.0) == Approx(3.0).epsilon(1e-7));  // a double root is good to the root of round-off
    CHECK(contact(3.0, 1.0 - 1e-12, -1.0, 0.0) < 3.0);
}

TEST_CASE("touching or overlapping and approaching is now, receding never") {
    CHECK(contact(1.0, 0.0, -1.0, 0.0) == 0.0);
    CHECK(contact(1.0 - 1e-12, 0.0, -1.0, 0.0) == 0.0);
    CHECK(contact(1.0 - 1e-12, 0.0, 1.0, 0.0) == md::never);
    CHECK(contact(1.0, 0.0, 0.0, 1.0) == md::never);
}

TEST_CASE("at the predicted time the distance is one diameter to round-off, grazing included") {
    scene::RandomStream random(3);
    int met = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const double x = random.uniform(1.0, 5.0), y = random.uniform(0.0, 1.0),
                     speed = std::exp(random.uniform(-5.0, 5.0));
        if (x * x + y * y < 1.0) continue;
        const double t = contact(x, y, -speed, 0.0);
        if (t == md::never) continue;
        ++met;
        const double distance = std::hypot(x - speed * t, y);
        REQUIRE(std::abs(distance - 1.0) < 5e-14);  // round-off: ten operations on squares up to 26
    }
    CHECK(met > 10000);
}

TEST_CASE("a particle rises to the ceiling only if its speed carries it there") {
    CHECK(md::time_to_ceiling(2.0, 2.5) == Approx(1.0).epsilon(1e-15));
    CHECK(md::time_to_ceiling(2.0, 1.9) == md::never);
    CHECK(md::time_to_ceiling(2.0, -1.0) == md::never);
    CHECK(md::time_to_ceiling(2.0, 2.0) == Approx(2.0).epsilon(1e-7));
    CHECK(md::time_to_ceiling(-1e-13, 1.0) == 0.0);
    CHECK(md::time_to_ceiling(-1e-13, -1.0) == md::never);
}

TEST_CASE("leaving a sphere takes as long as the straight path inside it") {
    CHECK(md::time_to_leave(0.0, 0.0, 4.0, 1.0) == 0.5);
    CHECK(md::time_to_leave(0.5, 0.25, 1.0, 1.0) == Approx(0.5).epsilon(1e-15));
    CHECK(md::time_to_leave(-0.5, 0.25, 1.0, 1.0) == Approx(1.5).epsilon(1e-15));
    CHECK(md::time_to_leave(0.0, 0.25, 0.0, 1.0) == md::never);
}
