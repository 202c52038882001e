// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "md/errors.hpp"
#include "md/initial_state.hpp"
#include "small_systems.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

md::Box slab() { return {10.0, 10.0, 200.0, false, scene::PlateMotion::from_acceleration(3.0, 0.1)}; }

md::Box cube(std::int64_t particles, double volume_fraction) {
    const double length = std::cbrt(static_cast<double>(particles) * std::numbers::pi / (6.0 * volume_fraction));
    return {length, length, length, true, {}};
}

}  // namespace

TEST_CASE("a start has no overlap, its temperature and no momentum") {
    const double fraction = GENERATE(0.05, 0.3, 0.48, 0.5, 0.6);
    const bool layered = GENERATE(true, false);
    const std::int64_t particles = 1000;
    const md::Box box = layered ? slab() : cube(particles, fraction);
    INFO("volume fraction " << fraction << (layered ? ", layer" : ", cube"));
    const md::Snapshot start = md::make_initial_state({particles, fraction, 2.5, 4}, box);
    REQUIRE(start.position.size() == 1000);
    const md::Audit audit = md::audit(start, box);
    CHECK(audit.largest_overlap <= 1e-14);  // round-off of a lattice at its closest
    CHECK(audit.deepest_in_plate <= 0.0);
    CHECK(audit.deepest_in_ceiling <= 0.0);
    double square = 0.0, top = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
        double momentum = 0.0;
        for (const auto& v : start.velocity) momentum += v[a];
        CHECK(std::abs(momentum) < 1e-10);  // round-off of a sum of 1000
    }
    for (const auto& v : start.velocity) square += v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    for (const auto& r : start.position) top = std::max(top, r[2]);
    CHECK(square / 3000.0 == Approx(2.5).epsilon(1e-13));
    if (layered) CHECK(top + 0.5 <= std::max(1.0, 1000 * std::numbers::pi / 6.0 / (100.0 * fraction)) + 1e-12);
}

TEST_CASE("a start depends on the seed and on nothing else") {
    const md::Box box = slab();
    const auto one = md::make_initial_state({500, 0.3, 1.0, 4}, box),
               same = md::make_initial_state({500, 0.3, 1.0, 4}, box);
    const auto other = md::make_initial_state({500, 0.3, 1.0, 5}, box);
    CHECK(one.position == same.position);
    CHECK(one.velocity == same.velocity);
    CHECK(one.position != other.position);
}

TEST_CASE("either seed of a scene changes its start") {
    const auto start = [](std::uint64_t of_state, std::uint64_t of_engine) {
        auto scene = small::layer();
        scene.initial.seed = of_state;
        scene.md.seed = of_engine;
        return md::Simulation(scene).snapshot().position;
    };
    const auto one = start(1, 1), another_state = start(2, 1), another_engine = start(1, 2);
    CHECK(start(1, 1) == one);
    CHECK(another_state != one);
    CHECK(another_engine != one);
    CHECK(another_state != another_engine);
}

TEST_CASE("particles that cannot fit are refused") {
    CHECK_THROWS_AS(md::make_initial_state({1000, 0.74, 1.0, 1}, slab()), md::CannotSetUp);
    CHECK_THROWS_AS(md::make_initial_state({1000000, 0.3, 1.0, 1}, slab()), md::CannotSetUp);
}
