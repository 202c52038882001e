// SPDX-License-Identifier: MIT
#include "plan/trials.hpp"

#include <numeric>

#include "compare/scenes.hpp"
#include "md/errors.hpp"
#include "md/simulation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/command.hpp"

using namespace shaken;

TEST_CASE("a trial whose grains collapse is none, and says why where there must be one") {
    const scene::Scene scene = compare::read_scene(support::small_scene, {"particles.restitution=0.3"});
    plan::Trials trials(scene, 1.0);
    CHECK(trials.grains(scene, 2, false) == nullptr);
    CHECK(trials.grains(scene, 2, false) == nullptr);
    CHECK_THROWS_AS(trials.grains(scene, 2, true), md::Stalled);
}

TEST_CASE("a trial is made once, and tells what every run of its length takes besides its cycles") {
    const scene::Scene scene = compare::read_scene(support::small_scene, {});
    plan::Trials trials(scene, 0.01);
    const double before = plan::cpu_seconds();
    const md::Simulation simulation(scene);
    const double to_begin = plan::cpu_seconds() - before;
    const double spent = trials.spent();
    const plan::Grains* grains = trials.grains(scene, 2, false);
    REQUIRE(grains);
    CHECK(grains == trials.grains(scene, 2, true));
    CHECK(grains->seconds.size() == 18);  // two to settle and the least after them
    // Of a clock: to begin takes its time again, within a factor, and nothing is counted that was not spent.
    CHECK(grains->seconds_once > 0.3 * to_begin);
    const double of_cycles = std::accumulate(grains->seconds.begin(), grains->seconds.end(), 0.0);
    CHECK(grains->seconds_once + of_cycles < trials.spent() - spent);
}
