// SPDX-License-Identifier: MIT
#include <cmath>

#include "continuum/errors.hpp"
#include "continuum/initial_state.hpp"
#include "continuum/solver.hpp"
#include "continuum/step/evolution.hpp"
#include "files/checkpoint.hpp"
#include "files/errors.hpp"
#include "scene/errors.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

using namespace continuum;

namespace {

/// The layer of chapter 4, figure 4.1.
scene::Scene chapter_4() {
    scene::Scene scene;
    scene.particles.restitution = scene::RestitutionConstant{0.9};
    scene.number_of_particles = 3937;
    scene.depth = 0.9 * scene.number_per_area();
    scene.motion = scene::PlateMotion::from_acceleration(3.0, 0.095);
    return scene;
}

/// A shallow one that needs fewer cells.
scene::Scene small_layer() {
    scene::Scene scene;
    scene.particles.restitution = scene::RestitutionVelocity{0.7, 1.0};
    scene.number_of_particles = 6 * 400;
    scene.depth = 5.4;
    scene.motion = scene::PlateMotion::from_acceleration(2.2, 0.18);
    scene.continuum.spacing = 0.4;
    scene.continuum.lid = 25.0;
    scene.sample.phases = 20;
    return scene;
}

double centre_of_mass(const Solver& solver, const scene::PlateMotion& motion) {
    const ColumnView column = solver.column(0, 0);
    double mass = 0.0, moment = 0.0;
    for (std::size_t i = 0; i < column.density.size(); ++i) {
        mass += column.density[i];
        moment += column.density[i] * (static_cast<double>(i) + 0.5) * solver.spacing_z();
    }
    return moment / mass + motion.position(solver.time_in_cycle());
}

}  // namespace

TEST_CASE("a layer starts with its particles on the plate") {
    const scene::Scene scene = chapter_4();
    const Solver solver(scene);
    CHECK(solver.cells_x() == 1);
    CHECK(solver.cells_z() == 400);
    // The density floor above the layer holds 1e-7 of the mass.
    CHECK(solver.mass() == Approx(9.8425).epsilon(2e-7));
    CHECK(centre_of_mass(solver, scene.motion) == Approx(0.5 * 9.8425 / (0.3 * 6.0 / 3.14159265358979)).epsilon(1e-4));
}

TEST_CASE("a shaken layer keeps its mass and its energy ledger over 10^5 steps", "[conservation]") {
    Solver solver(small_layer());
    const double mass = solver.mass();
    for (std::int64_t cycle = 1; solver.steps() < 100000; ++cycle) solver.advance_to_instant(cycle, 0);
    // Round-off: each cell rounds at random a few times a step, sqrt(1e5 * 60) * eps of the mean, not eps * 1e5.
    CHECK(solver.mass() == Approx(mass).epsilon(6e-13));
    const Ledger l = solver.ledger();
    const double terms =
        l.initial_energy + l.body_force_work - l.collisional_loss + l.floor_gain + l.dual_energy_gain + l.boundary_gain;
    CHECK(l.body_force_work > 100.0);
    CHECK(l.energy == Approx(terms).margin(1e-12 * l.body_force_work));
    // Round-off of a sum over 1e5 steps against one over the cells.
    CHECK(l.gravity_work == Approx(-l.potential_gain).margin(1e-10));
    // The two devices that are no physics must stay small.
    CHECK(std::abs(l.dual_energy_gain) < 1e-3 * l.collisional_loss);
    CHECK(std::abs(l.floor_gain) < 1e-6 * l.collisional_loss);
}

TEST_CASE("the plate carries the layer: its mean push is the weight") {
    Solver solver(small_layer());
    solver.advance_to_instant(12, 0);
    const Ledger before = solver.ledger();
    solver.advance_to_instant(20, 0);
    const Ledger after = solver.ledger();
    const double time = 8.0 / 0.18;
    const double push = (after.plate_impulse - before.plate_impulse - (after.lid_impulse - before.lid_impulse)) / time;
    // What is left is the momentum of the layer between the two ends, zero if the cycle repeats; in the plate's frame
    // the acceleration averages out.
    CHECK(push == Approx(solver.mass()).epsilon(2e-3));
}

TEST_CASE("a restored solver goes on bit for bit") {
    const support::TemporaryFolder folder;
    const scene::Scene scene = small_layer();
    Solver straight(scene);
    straight.advance_to_instant(1, 7);
    files::CheckpointWriter writer;
    straight.save(writer);
    writer.commit(folder / "state");
    Solver resumed(scene);
    resumed.restore(files::CheckpointReader(folder / "state"));
    CHECK(resumed.state_hash() == straight.state_hash());
    straight.advance_to_instant(2, 3);
    resumed.advance_to_instant(2, 3);
    CHECK(resumed.state_hash() == straight.state_hash());
    CHECK(resumed.steps() == straight.steps());
    CHECK(resumed.cycle() == 2);
    CHECK(resumed.phase_index() == 3);

    scene::Scene other = scene;
    other.continuum.spacing = 0.5;
    Solver misfit(other);
    CHECK_THROWS_AS(misfit.restore(files::CheckpointReader(folder / "state")), files::Damaged);
}

TEST_CASE("a run that fails says where and when") {
    scene::Scene frozen = small_layer();
    frozen.particles.restitution = scene::RestitutionConstant{0.6};
    frozen.continuum.floor_temperature = 0.5;
    Solver cold(frozen);
    CHECK_THROWS_WITH(cold.advance_to_instant(5, 0), Contains("temperature floor") && Contains("cycle 0"));

    Setup setup = make_setup(small_layer());
    setup.flow.temperature[static_cast<std::size_t>(setup.grid.first(0)) + 5] = std::nan("");
    Evolution poisoned(setup);
    CHECK_THROWS_WITH(poisoned.step(0.25, 0.01), Contains("0.25") && Contains("height"));
}

TEST_CASE("how often one looks does not change the flow") {
    Solver once(small_layer()), often(small_layer());
    once.advance_to_instant(1, 0);
    for (std::int64_t phase = 1; phase < 20; ++phase) {
        often.advance_to_instant(0, phase);
        (void)often.state_hash();
    }
    often.advance_to_instant(1, 0);
    CHECK(once.state_hash() == often.state_hash());
    CHECK_THROWS_AS(once.advance_to_instant(0, 5), std::logic_error);
}

TEST_CASE("a layer that cannot start is refused in words") {
    scene::Scene scene = small_layer();
    scene.continuum.lid = 8.0;
    CHECK_THROWS_WITH(Solver(scene), Contains("continuum.lid"));
    scene = small_layer();
    scene.initial.volume_fraction = 0.66;
    CHECK_THROWS_WITH(Solver(scene), Contains("volume_fraction"));
    scene = small_layer();
    scene.continuum.dimension = {"4", {}};
    CHECK_THROWS_AS(Solver(scene), scene::SceneError);
    scene = small_layer();
    scene.continuum.scheme = {"muscle", {}};
    CHECK_THROWS_WITH(Solver(scene), Contains("muscl"));
}

TEST_CASE("the layer of chapter 4 becomes periodic and its centre of mass converges with the spacing") {
    const auto heights = [](double spacing) {
        scene::Scene scene = chapter_4();
        scene.continuum.spacing = spacing;
        scene.continuum.lid = 120.0;  // the lowest that its gas does not reach
        Solver solver(scene);
        std::vector<double> last, now;
        for (std::int64_t cycle = 11; cycle <= 12; ++cycle) {
            last = now;
            now.clear();
            for (std::int64_t k = 0; k < 20; ++k) {
                solver.advance_to_instant(cycle, 10 * k);
                now.push_back(centre_of_mass(solver, scene.motion));
            }
        }
        for (std::size_t k = 0; k < 20; ++k) CHECK(now[k] == Approx(last[k]).epsilon(5e-4));
        return now;
    };
    const std::vector<double> coarse = heights(0.4), fine = heights(0.2);
    double squares = 0.0;
    for (std::size_t k = 0; k < 20; ++k) squares += std::pow(coarse[k] / fine[k] - 1.0, 2);
    INFO("rms difference of z_cm between dz = 0.4 and 0.2: " << std::sqrt(squares / 20));
    CHECK(std::sqrt(squares / 20) < 1e-3);
}
