// SPDX-License-Identifier: MIT
#include "scene/schedule.hpp"

#include <vector>

#include "scene/errors.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

using scene::Instant;
using scene::Schedule;

namespace {

/// Twenty instants in each of 2 + 3 cycles of a plate of period 4.
scene::Scene layer() {
    scene::Scene scene;
    scene.motion.frequency = 0.25;
    scene.sample.phases = 20;
    scene.sample.settle = 2;
    scene.sample.average = 3;
    return scene;
}

std::vector<std::int64_t> frames_of(const scene::Scene& scene) {
    const Schedule schedule(scene);
    std::vector<std::int64_t> kept;
    for (std::int64_t sample = 0; sample < schedule.samples(); ++sample)
        if (schedule.is_frame(schedule.instant(sample))) kept.push_back(sample);
    return kept;
}

}  // namespace

TEST_CASE("samples count instants through all cycles, and each has its phase and its time") {
    const Schedule schedule(layer());
    CHECK(schedule.samples() == 100);
    CHECK(schedule.cycles() == 5);
    for (const std::int64_t sample : {0, 19, 20, 99}) CHECK(schedule.sample(schedule.instant(sample)) == sample);
    const Instant at{3, 5};
    CHECK(schedule.instant(65) == at);
    CHECK(schedule.phase(at) == 0.25);  // all exact in binary
    CHECK(schedule.time_in_cycle(at) == 1.0);
    CHECK(schedule.time(at) == 13.0);
}

TEST_CASE("the last cycles are averaged over, counted from 0") {
    const Schedule schedule(layer());
    CHECK_FALSE(schedule.is_averaged(1));
    CHECK(schedule.is_averaged(2));
    CHECK(schedule.averaged_cycle(2) == 0);
    CHECK(schedule.is_averaged(4));
    CHECK_FALSE(schedule.is_averaged(5));
    CHECK(schedule.settling_samples() == 40);
}

TEST_CASE("frames of a layer are kept at equal phases of its last cycles") {
    scene::Scene scene = layer();
    scene.sample.frames = 2;
    CHECK(frames_of(scene) == std::vector<std::int64_t>{80, 90});
    scene.sample.frame_cycles = 2;
    CHECK(frames_of(scene) == std::vector<std::int64_t>{60, 70, 80, 90});
    scene.sample.frames = 0;
    CHECK(frames_of(scene).empty());
}

TEST_CASE("maps are kept at equal phases of every cycle, where the scene asks for them") {
    scene::Scene scene = layer();
    scene.sample.maps = 4;
    CHECK_FALSE(Schedule(scene).is_map({0, 5}));
    scene.sample.map_bin = 2.0;
    CHECK(Schedule(scene).is_map({0, 5}));
    CHECK(Schedule(scene).is_map({4, 15}));
    CHECK_FALSE(Schedule(scene).is_map({4, 6}));
}

TEST_CASE("a gas is sampled at its start and after each interval, with frames at the ends of equal parts") {
    scene::Scene scene;
    scene.kind = scene::Kind::uniform;
    scene.uniform.interval = 0.9;
    scene.motion.frequency = 1.0 / 0.9;
    scene.sample.phases = scene.sample.maps = 1;
    scene.sample.settle = 2;
    scene.sample.average = 6;
    scene.uniform.frames = 2;
    const Schedule schedule(scene);
    CHECK(schedule.samples() == 9);
    CHECK(schedule.time({1, 0}) == 0.9);  // to the last bit: 1/(1/0.9) is another number
    CHECK(frames_of(scene) == std::vector<std::int64_t>{5, 8});
}

TEST_CASE("a layer starts at the instant of its file's phase, and another phase is refused") {
    scene::Scene scene = layer();
    scene.initial.phase = 0.35;
    CHECK(scene::start_of(scene) == Instant{});  // nothing to start from
    scene.initial.file = "earlier.h5";
    CHECK(scene::start_of(scene) == Instant{0, 7});
    scene.initial.phase = 0.36;
    CHECK_THROWS_AS(scene::start_of(scene), scene::SceneError);
    scene.initial.phase = 0.35;
    scene.sample.settle = 0;
    scene.sample.average = 1;
    CHECK_THROWS_AS(scene::start_of(scene), scene::SceneError);
}
