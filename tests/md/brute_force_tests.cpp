// SPDX-License-Identifier: MIT
// Every event of the engine against a search that knows no lists, no queue and no moving frame: from the state before
// the event, the earliest contact of all pairs and walls.
#include <cmath>

#include "md/contact_time.hpp"
#include "md/plate_contact_time.hpp"
#include "small_systems.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

using Kind = md::ContactEvent::Kind;

struct Next {
    Kind kind = Kind::pair;
    std::size_t first = 0, second = 0;
    double delay = md::never;
};

/// All pairs over `images` images to each side, all particles against both walls.
Next search(const md::Snapshot& s, const md::Box& box, int images) {
    Next next;
    const auto better = [&](double delay, Kind kind, std::size_t i, std::size_t j) {
        if (delay < next.delay) next = {kind, i, j, delay};
    };
    for (std::size_t i = 0; i < s.position.size(); ++i) {
        for (std::size_t j = i + 1; j < s.position.size(); ++j)
            for (int kx = -images; kx <= images; ++kx)
                for (int ky = -images; ky <= images; ++ky)
                    for (int kz = box.periodic_z ? -images : 0; kz <= (box.periodic_z ? images : 0); ++kz) {
                        const double x = s.position[j][0] - s.position[i][0] + kx * box.x,
                                     u = s.velocity[j][0] - s.velocity[i][0];
                        const double y = s.position[j][1] - s.position[i][1] + ky * box.y,
                                     v = s.velocity[j][1] - s.velocity[i][1];
                        const double z = s.position[j][2] - s.position[i][2] + kz * box.z,
                                     w = s.velocity[j][2] - s.velocity[i][2];
                        better(md::time_to_contact(x * u + y * v + z * w, x * x + y * y + z * z, u * u + v * v + w * w),
                               Kind::pair, i, j);
                    }
        if (box.periodic_z) continue;
        const double now = s.time_in_cycle;
        better(md::plate_contact_time(*box.plate, s.position[i][2] - 0.5, s.velocity[i][2], now,
                                      now + box.plate->period()) -
                   now,
               Kind::plate, i, i);
        better(md::time_to_ceiling(box.z - 0.5 - s.position[i][2], s.velocity[i][2]), Kind::ceiling, i, i);
    }
    return next;
}

void compare(md::Simulation& simulation, const md::Box& box, int events, int images = 1) {
    int walls = 0;
    for (int n = 0; n < events; ++n) {
        const md::Snapshot before = simulation.snapshot();
        const Next expected = search(before, box, images);
        const md::ContactEvent found = simulation.advance_contact();
        const double elapsed = static_cast<double>(found.cycle - before.cycle) * simulation.plate_period() +
                               found.time_in_cycle - before.time_in_cycle;
        INFO("event " << n << ": expected " << expected.first << " and " << expected.second << " after "
                      << expected.delay << ", found " << found.first << " and " << found.second << " after "
                      << elapsed);
        REQUIRE(found.kind == expected.kind);
        // The snapshot rounds positions of size 10: a contact time is good to that over the speed, or to its root
        // where it grazes.
        REQUIRE(elapsed == Approx(expected.delay).margin(1e-7));
        const auto first = static_cast<std::int64_t>(expected.first),
                   second = static_cast<std::int64_t>(expected.second);
        if (found.kind == Kind::pair) {
            REQUIRE(std::min(found.first, found.second) == first);
            REQUIRE(std::max(found.first, found.second) == second);
        } else {
            REQUIRE(found.first == first);
            ++walls;
        }
    }
    if (!box.periodic_z) CHECK(walls > events / 100);
}

}  // namespace

TEST_CASE("every contact of a small shaken layer is the one a search over all pairs and walls finds") {
    auto scene = small::layer(25);
    scene.box = {3.5, 4.0, 12.0};
    scene.initial.temperature = 5.0;  // some reach the ceiling
    md::Simulation simulation(scene);
    compare(simulation, {scene.box.x, scene.box.y, scene.box.ceiling, false, scene.motion}, 4000);
    CHECK(simulation.counters().ceiling_collisions > 0);
}

TEST_CASE("every contact of a small periodic gas is the one a search over all pairs and images finds") {
    const double fraction = GENERATE(0.05, 0.45);
    const auto system = small::gas(40, fraction, 0.95);
    md::Simulation simulation(system);
    const double length = system.box_length();
    compare(simulation, {length, length, length, true, {}}, 1500);
}

TEST_CASE("every one of a million contacts is the one a search over all pairs finds", "[slow]") {
    auto scene = small::layer(12);
    scene.box = {3.0, 3.0, 10.0};
    scene.initial.temperature = 5.0;
    md::Simulation layer(scene);
    compare(layer, {scene.box.x, scene.box.y, scene.box.ceiling, false, scene.motion}, 500000,
            3);  // fast ones cross the small box
    const auto system = small::gas(16, 0.3, 1.0);
    md::Simulation gas(system);
    const double length = system.box_length();
    compare(gas, {length, length, length, true, {}}, 500000, 2);
}
