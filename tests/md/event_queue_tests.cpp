// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "md/event_queue.hpp"
#include "md/random_stream.hpp"

using namespace shaken;

namespace {

/// Runs the queue beside a std::multiset through random pops and replacements; expected sets the bucket width.
void compare_with_multiset(double expected, double horizon, double grid) {
    constexpr std::uint32_t owners = 300;
    md::RandomStream random(13);
    md::EventQueue queue(owners);
    queue.reset(0.0, horizon, expected);
    std::multiset<std::pair<double, std::uint32_t>> plain;
    std::vector<double> times(owners);
    double now = 0.0;
    const auto later = [&] {
        const double delay = -std::log1p(-random.uniform());
        return grid > 0.0 ? now + grid * std::floor(delay / grid) : now + delay;  // on a grid ties abound
    };
    const auto schedule = [&](std::uint32_t owner, double time) {
        queue.schedule(owner, time);
        times[owner] = time;
        plain.insert({time, owner});
    };
    for (std::uint32_t i = 0; i < owners; ++i) schedule(i, later());
    std::int64_t popped = 0;
    while (true) {
        const md::QueuedEvent first = queue.front();
        if (plain.begin()->first > horizon) {
            REQUIRE(first.time == std::numeric_limits<double>::infinity());
            break;
        }
        REQUIRE(first.time == plain.begin()->first);
        REQUIRE(first.owner == plain.begin()->second);
        now = first.time;
        plain.erase(plain.begin());
        schedule(first.owner, grid > 0.0 ? later() + grid : later());
        for (int other = 0; other < 2; ++other) {  // collisions replace other owners' events too
            const auto owner = static_cast<std::uint32_t>(random.index(owners));
            plain.erase(plain.find({times[owner], owner}));
            schedule(owner, later());
        }
        ++popped;
    }
    CHECK(popped > 5000);
}

}  // namespace

TEST_CASE("the queue pops what a std::multiset pops, whatever the bucket width") {
    const double expected = GENERATE(1.0, 300.0, 1e4, 1e6);
    compare_with_multiset(expected, 20.0, 0.0);
}

TEST_CASE("equal times are popped by owner, as by a std::multiset") { compare_with_multiset(1e4, 20.0, 0.125); }

TEST_CASE("events after the horizon stay parked until a reset") {
    md::EventQueue queue(2);
    queue.reset(0.0, 1.0, 10.0);
    queue.schedule(0, 2.0);
    queue.schedule(1, 1.0);
    CHECK(queue.front().owner == 1);
    queue.schedule(1, 1.5);
    CHECK(queue.front().time == std::numeric_limits<double>::infinity());
}

TEST_CASE("an event in the past of the queue comes first") {
    md::EventQueue queue(3);
    queue.reset(0.0, 1.0, 1000.0);
    queue.schedule(0, 0.5);
    queue.schedule(1, 0.6);
    queue.schedule(2, 0.9);
    CHECK(queue.front().owner == 0);
    queue.schedule(2, 0.5);
    queue.schedule(0, 0.7);
    CHECK(queue.front().owner == 2);
}
