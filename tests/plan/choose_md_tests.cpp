// SPDX-License-Identifier: MIT
// What a plan promises of several seeds: their error and their time, from one trial.
#include <cmath>
#include <thread>

#include "compare/scenes.hpp"
#include "plan/choices.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/command.hpp"

using namespace shaken;

namespace {

/// A layer in its whole cell, that forgets its start in so many cycles.
plan::ContinuumPlan settled_after(std::int64_t cycles) {
    plan::ContinuumPlan continuum;
    continuum.dimension = 3;
    continuum.scheme = "muscl";
    continuum.spacing = 0.5;
    continuum.spacing_horizontal = 2.0;
    continuum.lid = 40.0;
    continuum.settle = cycles;
    continuum.settle_of_trial = 4;
    return continuum;
}

}  // namespace

TEST_CASE("a plan's promise holds with two seeds") {
    if (std::thread::hardware_concurrency() < 2) return;  // a plan takes no more seeds than run at a time
    const scene::Scene scene = compare::read_scene(support::small_scene);
    plan::Trials trials(scene, 0.3);
    const plan::Grains* grains = trials.grains(scene, 4, true);
    REQUIRE(grains);
    const double one_cycle = plan::spread(grains->heights, 4).value;  // standard error of a mean over one cycle
    // 0.85 of the error is for statistics, which then takes 55 cycles; a fifth of them is 2.2 times what settles.
    const double error = one_cycle / std::sqrt(55.0) / 0.85;
    const plan::MdPlan md = plan::choose_md(trials, settled_after(5), error);
    REQUIRE(md.seeds == 2);
    CHECK(md.particles == 200);
    CHECK(md.average == 30);  // tens of cycles a seed
    const double seeds = 2.0, average = 30.0;
    // Independent cycles of both seeds: the error of their mean falls with the root of all of them.
    CHECK(md.statistics == Approx(one_cycle / std::sqrt(seeds * average)).epsilon(1e-12));  // round-off
    CHECK(md.statistics <= 0.85 * error);
    const double each = grains->seconds_once + plan::seconds_of(*grains, md.settle + md.average);
    CHECK(md.seconds == Approx(seeds * (trials.start_of_program() + each)).epsilon(1e-12));
}

TEST_CASE("the MD of grains that may collapse keeps the scene's cell, whatever one trial does") {
    const scene::Scene scene = compare::read_scene(
        support::small_scene,
        {"box.x=12", "box.y=12", "particles.number=288", "particles.restitution=0.79", "initial.volume_fraction=0.1"});
    plan::ContinuumPlan flat = settled_after(2);
    flat.dimension = 1;
    plan::Trials trials(scene, 0.3);
    const plan::MdPlan md = plan::choose_md(trials, flat, 0.1);  // the small cell's error would be small enough
    CHECK(md.box_x == 12.0);
    CHECK(md.particles == 288);
    CHECK(md.small_cell_may_collapse);
    CHECK(md.cell == 0.0);
}

TEST_CASE("errors of the continuum that cancel on the trial's grids are counted all the same") {
    plan::ContinuumPlan continuum;
    continuum.grid = 0.003;
    continuum.lid_error = 0.004;
    CHECK(continuum.error() == Approx(0.005).epsilon(1e-14));  // round-off
    continuum.together.fill(0.007);                            // of one sign they add
    CHECK(continuum.error() == Approx(0.007).epsilon(1e-14));
}
