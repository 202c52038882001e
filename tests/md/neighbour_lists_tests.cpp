// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "md/neighbour_lists.hpp"
#include "scene/random_stream.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

std::vector<md::Particle> scattered(std::size_t count, const md::Box& box, scene::RandomStream& random) {
    std::vector<md::Particle> particles(count);
    for (md::Particle& p : particles) {
        p.x = random.uniform(0.0, box.x);
        p.y = random.uniform(0.0, box.y);
        p.z = random.uniform(0.0, box.z);
    }
    return particles;
}

/// Every list holds the particles whose centres are within reach, by all pairs. Cells search in single precision and
/// may let in a pair up to their margin too far, but never leave one out.
void check_against_all_pairs(const md::NeighbourLists& lists, std::size_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
        std::set<std::uint32_t> needed, allowed;
        for (std::uint32_t j = 0; j < count; ++j) {
            const auto &a = lists.centre(i), &b = lists.centre(j);
            const double x = lists.x().image(b.x - a.x), y = lists.y().image(b.y - a.y), z = lists.z().image(b.z - a.z);
            const double reach = 1.0 + static_cast<double>(a.half_shell) + static_cast<double>(b.half_shell);
            const double distance = std::sqrt(x * x + y * y + z * z);
            if (j != i && distance < reach) needed.insert(j);
            if (j != i && distance < reach + 2.0 * lists.margin()) allowed.insert(j);
        }
        const auto list = lists.of(i);
        const std::set<std::uint32_t> found(list.begin(), list.end());
        REQUIRE(list.size() == found.size());
        REQUIRE(std::includes(found.begin(), found.end(), needed.begin(), needed.end()));
        REQUIRE(std::includes(allowed.begin(), allowed.end(), found.begin(), found.end()));
    }
}

}  // namespace

TEST_CASE("neighbour lists equal all pairs after building, moving and shifting") {
    // Axes of one, two and many cells; the last box has heights that wrap around the repeating cells.
    const md::Box box = GENERATE(md::Box{3.0, 4.0, 9.0, true, {}}, md::Box{8.0, 2.4, 6.0, true, {}},
                                 md::Box{5.0, 6.0, 150.0, false, {}}, md::Box{12.0, 12.0, 12.0, true, {}});
    const double widest = box.y < 3.0 ? 0.1 : box.x < 4.0 ? 0.2 : 0.6;
    constexpr std::size_t count = 200;  // as dense as it comes: lists outgrow their first capacity
    scene::RandomStream random(17);
    auto particles = scattered(count, box, random);
    md::NeighbourLists lists(box, widest, count);
    lists.build(particles);
    check_against_all_pairs(lists, count);
    for (int move = 0; move < 1000; ++move) {
        const auto i = static_cast<std::uint32_t>(random.index(count));
        md::Particle& p = particles[i];
        p.x += random.normal();
        p.y += random.normal();
        p.z += random.normal();
        p.x = lists.x().wrapped(lists.x().wrapped(p.x));
        p.y = lists.y().wrapped(lists.y().wrapped(p.y));
        if (box.periodic_z) p.z = lists.z().wrapped(p.z);
        lists.rebuild(i, p);
        if (move % 250 == 0 && !box.periodic_z) {
            lists.shift_heights(-3.7);
            for (md::Particle& q : particles) q.z -= 3.7;
        }
        if (move % 100 == 0) check_against_all_pairs(lists, count);
    }
    check_against_all_pairs(lists, count);
}
