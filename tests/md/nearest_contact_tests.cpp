// SPDX-License-Identifier: MIT
#include <vector>

#include "md/nearest_contact.hpp"
#include "md/paged_vector.hpp"
#include "scene/random_stream.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

TEST_CASE("the first contact among neighbours is the plain search's to the last bit, for every length of list") {
    scene::RandomStream random(23);
    const md::Periodic x(8.0), y(9.0), z = GENERATE(md::Periodic(7.0), md::Periodic());
    int met = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        md::PagedVector<md::Particle> particles(40);
        const bool inside = trial % 2 == 0;
        for (md::Particle& p : particles) {
            p.x = inside ? random.uniform(3.0, 5.0) : random.uniform(0.0, 8.0);
            p.y = inside ? random.uniform(3.0, 5.0) : random.uniform(0.0, 9.0);
            p.z = inside ? random.uniform(3.0, 5.0) : random.uniform(0.0, 7.0);
            p.velocity_x = random.normal();
            p.velocity_y = random.normal();
            p.velocity_z = random.normal();
            p.time = -0.1 * random.uniform();
        }
        const double now = 0.0;
        particles[0].time = now;
        std::vector<std::uint32_t> list;
        for (int n = 0; n < trial % 19; ++n) list.push_back(static_cast<std::uint32_t>(1 + random.index(39)));
        const auto plain = md::nearest_contact_plain(particles[0], now, list, particles.data(), x, y, z);
        const auto fast = md::nearest_contact(particles[0], now, list, particles.data(), x, y, z, inside);
        INFO("trial " << trial);
        REQUIRE(fast.delay == plain.delay);
        // Several that overlap already are all due now: any of them may be named.
        if (plain.delay != md::never && plain.delay > 0.0) REQUIRE(fast.partner == plain.partner);
        met += plain.delay != md::never;
    }
    CHECK(met > 500);
}
