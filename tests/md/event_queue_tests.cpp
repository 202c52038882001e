// SPDX-License-Identifier: MIT
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "md/event_queue.hpp"
#include "scene/random_stream.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

/// Runs the queue beside a std::multiset through random pops and replacements; expected sets the bucket width.
void compare_with_multiset(double expected, double horizon, double grid) {
    constexpr std::uint32_t owners = 300;
    scene::RandomStream random(13);
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

/// As an engine uses it: epoch after epoch, each event replaces its owner's and a partner's, and half of all times lie
/// on a grid, so that many are equal. The queue, a std::multiset and a search of all owners must agree on every event.
void compare_sequences(std::int64_t events) {
    constexpr std::uint32_t owners = 200;
    constexpr double epoch = 4.0, grid = 1.0 / 64.0;
    scene::RandomStream random(31);
    md::EventQueue queue(owners);
    std::multiset<std::pair<double, std::uint32_t>> plain;
    std::vector<double> times(owners, 0.0);
    double start = 0.0, now = 0.0;
    const auto later = [&] {
        const double time = now - std::log1p(-random.uniform());
        return random.uniform() < 0.5 ? time : std::ceil(time / grid) * grid;
    };
    for (std::uint32_t i = 0; i < owners; ++i) plain.insert({times[i] = later(), i});
    std::int64_t popped = 0, ties = 0;
    while (popped < events) {
        queue.reset(start, start + epoch, epoch * owners);
        for (std::uint32_t i = 0; i < owners; ++i) queue.schedule(i, times[i], {i, 7});
        start += epoch;
        while (true) {
            const md::QueuedEvent first = queue.front();
            std::uint32_t earliest = 0;
            for (std::uint32_t i = 1; i < owners; ++i)
                if (times[i] < times[earliest]) earliest = i;  // of equal ones the first
            REQUIRE(plain.begin()->first == times[earliest]);
            REQUIRE(plain.begin()->second == earliest);
            if (times[earliest] > start) {
                REQUIRE(first.time == std::numeric_limits<double>::infinity());
                break;
            }
            REQUIRE(first.time == times[earliest]);
            REQUIRE(first.owner == earliest);
            REQUIRE(queue.subject(first.owner).partner == earliest);
            ties += first.time == now;
            now = first.time;
            ++popped;
            const auto partner = static_cast<std::uint32_t>(random.index(owners));
            for (const std::uint32_t owner : {earliest, partner}) {
                plain.erase(plain.find({times[owner], owner}));
                plain.insert({times[owner] = later(), owner});
                queue.schedule(owner, times[owner], {owner, 7});
            }
        }
    }
    CHECK(ties > events / 10);
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

TEST_CASE(
    "the queue, a std::multiset and a search of all owners agree on 100,000 events, many of them at equal times") {
    compare_sequences(100000);
}

TEST_CASE("the queue, a std::multiset and a search of all owners agree on a million events", "[slow]") {
    compare_sequences(1000000);
}
