// SPDX-License-Identifier: MIT
#include "scene/restitution.hpp"

#include "tests/support/catch.hpp"

using namespace shaken;

using namespace scene;

TEST_CASE("slow contacts are elastic and fast ones have e0") {
    const RestitutionVelocity law{0.7, 1.0};
    CHECK(law(0.0) == 1.0);
    CHECK(law(1.0) == 0.7);
    CHECK(law(25.0) == 0.7);
}

TEST_CASE("the velocity law is 1 - (1 - e0) v^(3/4), whatever the sign of v") {
    const RestitutionVelocity law{0.7, 1.0};
    for (const double v : {1e-6, 0.01, 0.3, 0.999}) {
        CHECK(law(v) == Approx(1.0 - 0.3 * std::pow(v, 0.75)).epsilon(1e-15));  // round-off
        CHECK(law(-v) == law(v));
    }
}

TEST_CASE("the law's speed scale rescales its argument") {
    const RestitutionVelocity law{0.7, 2.0}, unit{0.7, 1.0};
    CHECK(law(0.5) == unit(0.25));
}

TEST_CASE("e falls with speed and stays within [e0, 1]") {
    const RestitutionVelocity law{0.4, 1.0};
    double before = 1.0;
    for (double v = 0.0; v < 2.0; v += 0.01) {
        CHECK(law(v) <= before);
        CHECK(law(v) >= 0.4);
        before = law(v);
    }
}

TEST_CASE("every law names the restitution of fast contacts") {
    CHECK(fast_restitution(RestitutionConstant{0.9}) == 0.9);
    CHECK(fast_restitution(RestitutionVelocity{0.7, 1.0}) == 0.7);
}
