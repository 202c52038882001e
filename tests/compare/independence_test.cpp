// SPDX-License-Identifier: MIT
#include "compare/independence.hpp"

#include <algorithm>
#include <limits>
#include <random>

#include "files/errors.hpp"
#include "tests/support/catch.hpp"

using shaken::compare::AveragedRun;
using shaken::compare::refuse_dependent;

namespace {

constexpr int phases = 20;

/// Three cycles of heights that no other seed has.
AveragedRun run_of(const std::string& name, std::uint64_t seed, const std::string& start = "") {
    AveragedRun run{name, {}, {}};
    run.scene.md.seed = seed;
    run.scene.initial.file = start;
    run.scene.sample.phases = phases;
    std::mt19937_64 random(seed);
    for (int i = 0; i < 3 * phases; ++i)
        run.centre_of_mass.push_back(7.0 + static_cast<double>(random()) / static_cast<double>(random.max()));
    return run;
}

}  // namespace

TEST_CASE("runs of other seeds are independent, also where the start fills a lattice") {
    AveragedRun one = run_of("one", 1), other = run_of("other", 2);
    CHECK_NOTHROW(refuse_dependent({one, other}));
    one.centre_of_mass[0] = other.centre_of_mass[0] = 2.5;
    one.centre_of_mass[1] = other.centre_of_mass[1] = std::numeric_limits<double>::quiet_NaN();
    CHECK_NOTHROW(refuse_dependent({one, other}));
}

TEST_CASE("equal heights at other phases are no common cycle") {
    const AveragedRun one = run_of("one", 1, "a state");
    AveragedRun other = one;
    other.path = "other";
    std::rotate(other.centre_of_mass.begin(), other.centre_of_mass.begin() + 1, other.centre_of_mass.end());
    CHECK_NOTHROW(refuse_dependent({one, other}));
}

TEST_CASE("a third of a cycle in common is found wherever it stands, and both runs are named") {
    const AveragedRun one = run_of("one", 1, "a state"), between = run_of("between", 3);
    AveragedRun other = run_of("other", 2, "another state");
    for (std::size_t i = 0; i < 7; ++i) other.centre_of_mass[13 + i] = one.centre_of_mass[2 * phases + 13 + i];
    CHECK_THROWS_WITH(refuse_dependent({one, between, other}),
                      Contains("one and other are not independent") && Contains("share 0.35 cycles"));
}

TEST_CASE("equal seeds are one start unless a file gives it") {
    AveragedRun one = run_of("one", 1), other = run_of("other", 2);
    other.scene.md.seed = 1;
    CHECK_THROWS_AS(refuse_dependent({one, other}), shaken::files::Damaged);
    other.scene.initial.seed = 2;
    CHECK_NOTHROW(refuse_dependent({one, other}));
    other.scene.initial.seed = 1;
    other.scene.initial.file = "a state";
    CHECK_NOTHROW(refuse_dependent({one, other}));
}
