// SPDX-License-Identifier: MIT
// Starts from what an earlier run left: the same state at the same phase of the plate, under the laws of the new scene.
#include <cmath>

#include "files/checkpoint.hpp"
#include "files/errors.hpp"
#include "md/errors.hpp"
#include "md/h5md.hpp"
#include "scene/errors.hpp"
#include "small_systems.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

namespace {

/// A frictional layer: spins are part of the state.
scene::Scene rough_layer() {
    auto scene = small::layer();
    scene.particles.friction = {scene::FrictionLaw::walton, 0.35, 0.5};
    return scene;
}

/// Two cycles and `phase` of one more.
md::Simulation shaken_until(double phase) {
    md::Simulation simulation(rough_layer());
    simulation.advance_to(2, phase * simulation.plate_period());
    return simulation;
}

void save(const md::Simulation& simulation, const std::filesystem::path& path) {
    files::CheckpointWriter out;
    out.put_text("engine", "md");
    simulation.save(out);
    out.commit(path);
}

void check_same(const md::Snapshot& one, const md::Snapshot& other, double margin) {
    REQUIRE(one.position.size() == other.position.size());
    REQUIRE(one.spin.size() == other.spin.size());
    double apart = 0.0;
    for (std::size_t i = 0; i < one.position.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            apart = std::max({apart, std::abs(one.position[i][k] - other.position[i][k]),
                              std::abs(one.velocity[i][k] - other.velocity[i][k]),
                              std::abs(one.spin[i][k] - other.spin[i][k])});
    CHECK(apart < margin);
}

}  // namespace

TEST_CASE("a run starts from a checkpoint at any phase and goes on as the earlier run did") {
    const double phase = GENERATE(0.0, 0.35, 0.67, 0.995);
    const support::TemporaryFolder folder;
    md::Simulation first = shaken_until(phase);
    auto scene = rough_layer();
    scene.initial.file = folder.path() / "md.checkpoint";
    scene.initial.phase = phase;
    save(first, scene.initial.file);
    md::Simulation second(scene);
    CHECK(second.cycle() == 0);
    CHECK(second.time_in_cycle() == Approx(phase * second.plate_period()).margin(1e-14));
    check_same(second.snapshot(), first.snapshot(), 1e-13);  // the frame takes a mean velocity out and puts it back
    // Round-off grows as e per collision of a particle: for a few collisions the two are the same.
    const double later = phase + 0.02, turn = std::floor(later);
    const double period = first.plate_period();
    const std::int64_t before = first.counters().pair_collisions;
    first.advance_to(2 + static_cast<std::int64_t>(turn), (later - turn) * period);
    second.advance_to(static_cast<std::int64_t>(turn), (later - turn) * period);
    CHECK(second.counters().pair_collisions == first.counters().pair_collisions - before);
    check_same(second.snapshot(), first.snapshot(), 1e-9);
}

TEST_CASE("a run starts from the frame of a trajectory at its initial.phase, spins and all, under another law") {
    const support::TemporaryFolder folder;
    auto scene = rough_layer();
    scene.initial.file = folder.path() / "md.h5";
    const md::Box box{scene.box.x, scene.box.y, scene.box.ceiling, false, scene.motion};
    const md::Simulation early = shaken_until(0.35), late = shaken_until(0.67);
    md::H5mdWriter writer(scene.initial.file, box, {"[scene]\n", 1, ""});
    writer.append(early.snapshot(), 0, 0.35);
    writer.append(late.snapshot(), 1, 0.67);
    writer.file().write("/particles/all/phase", std::vector<double>{0.35, 0.67});
    writer.close();
    scene.particles.restitution = scene::RestitutionConstant{0.75};
    for (const auto* wanted : {&early, &late}) {
        scene.initial.phase = wanted == &early ? 0.35 : 0.67;
        md::Simulation second(scene);
        check_same(second.snapshot(), wanted->snapshot(), 1e-13);
        CHECK(second.time_in_cycle() == Approx(wanted->time_in_cycle()).margin(1e-14));
        CHECK_NOTHROW(second.advance_to(3, 0.0));
    }
    scene.particles.friction = {};  // smooth particles have no spins
    CHECK(md::Simulation(scene).snapshot().spin.empty());
}

TEST_CASE("a start that the scene contradicts is refused with what is there") {
    const support::TemporaryFolder folder;
    auto scene = rough_layer();
    scene.initial.file = folder.path() / "md.checkpoint";
    save(shaken_until(0.35), scene.initial.file);
    CHECK_THROWS_WITH(md::Simulation(scene), Contains("initial.phase = 0") && Contains("at 0.35"));
    scene.initial.phase = 0.35;
    CHECK_NOTHROW(md::Simulation(scene));
    auto other = scene;
    other.number_of_particles = 149;
    CHECK_THROWS_WITH(md::Simulation(other), Contains("150 particles, the scene has 149"));
    other = scene;
    other.box.y = 7.5;
    CHECK_THROWS_WITH(md::Simulation(other), Contains("of a box of 6 x 7"));
    other = scene;
    other.sample.phases = 30;
    CHECK_THROWS_WITH(md::Simulation(other), Contains("is no sample instant of sample.phases = 30"));
    other = scene;
    other.sample.settle = 0;
    other.sample.average = 1;
    CHECK_THROWS_AS(md::Simulation(other), scene::SceneError);
    other.initial.file = folder.path() / "absent";
    CHECK_THROWS_AS(md::Simulation(other), files::NoInput);
}
