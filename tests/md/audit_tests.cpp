// SPDX-License-Identifier: MIT
// The audit that every long run ends with: the deepest overlap, through every face and whoever has the lower number.
#include <algorithm>
#include <cmath>

#include "md/audit.hpp"
#include "scene/random_stream.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

md::Box gas() { return {6.0, 7.0, 5.0, true, {}}; }
md::Box slab() { return {6.0, 7.0, 9.0, false, scene::PlateMotion::from_acceleration(3.0, 0.1)}; }

md::Snapshot at(std::vector<std::array<double, 3>> positions, double time = 0.0) {
    md::Snapshot s;
    s.time_in_cycle = time;
    s.velocity.assign(positions.size(), {});
    s.position = std::move(positions);
    return s;
}

/// The largest overlap by its definition: all pairs, all images.
double naive_overlap(const md::Snapshot& s, const md::Box& box) {
    double nearest = 1.0;
    for (std::size_t i = 0; i < s.position.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            for (int x = -1; x <= 1; ++x)
                for (int y = -1; y <= 1; ++y)
                    for (int z = box.periodic_z ? -1 : 0; z <= (box.periodic_z ? 1 : 0); ++z)
                        nearest = std::min(nearest, std::hypot(s.position[i][0] - s.position[j][0] + x * box.x,
                                                               s.position[i][1] - s.position[j][1] + y * box.y,
                                                               s.position[i][2] - s.position[j][2] + z * box.z));
    return 1.0 - nearest;
}

}  // namespace

TEST_CASE("the audit sees two that overlap through any face, edge or corner, whichever has the lower number") {
    const md::Box box = gas();
    const std::array<double, 3> length{box.x, box.y, box.z};
    const int faces = GENERATE(range(1, 8));  // one bit an axis
    std::array<double, 3> low{2.0, 2.0, 2.0}, high = low;
    double square = 0.0;
    for (std::size_t a = 0; a < 3; ++a)
        if (faces >> a & 1) {
            low[a] = 0.1;
            high[a] = length[a] - 0.3;
            square += 0.4 * 0.4;
        }
    for (const auto& pair : {at({low, high}), at({high, low})}) {
        const md::Audit found = md::audit(pair, box);
        CHECK(found.largest_overlap == Approx(1.0 - std::sqrt(square)).margin(1e-14));  // round-off of a length of 7
        CHECK(std::min(found.first, found.second) == 0);
        CHECK(std::max(found.first, found.second) == 1);
    }
}

TEST_CASE("the audit finds what a search over all pairs and images finds") {
    const md::Box box = GENERATE(gas(), slab());
    scene::RandomStream random(3);
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<std::array<double, 3>> positions(8);
        for (auto& r : positions)
            r = {random.uniform(0.0, box.x), random.uniform(0.0, box.y), random.uniform(0.0, box.z)};
        const md::Snapshot some = at(positions);
        CHECK(md::audit(some, box).largest_overlap == Approx(naive_overlap(some, box)).margin(1e-14));  // round-off
    }
}

TEST_CASE("the audit says how deep a particle lies in the plate where it is, and in the ceiling") {
    const md::Box box = slab();
    const double half = 0.5 * box.plate->period(), floor = box.plate->position(half);
    REQUIRE(floor > 1.0);
    CHECK(md::audit(at({{1.0, 1.0, floor + 0.4}}, half), box).deepest_in_plate ==
          Approx(0.1).margin(1e-14));  // round-off
    CHECK(md::audit(at({{1.0, 1.0, floor + 0.6}}, half), box).deepest_in_plate <= 0.0);
    CHECK(md::audit(at({{1.0, 1.0, box.z - 0.3}}), box).deepest_in_ceiling == Approx(0.2).margin(1e-14));
    CHECK(md::audit(at({{1.0, 1.0, box.z - 0.7}}), box).deepest_in_ceiling <= 0.0);
}
