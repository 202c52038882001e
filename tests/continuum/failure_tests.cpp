// SPDX-License-Identifier: MIT
// Where a method fails it says so, with place and time, and leaves a state to look at.
#include <cmath>
#include <limits>

#include "cases.hpp"
#include "continuum/advance.hpp"
#include "continuum/errors.hpp"
#include "continuum/ftcs/ftcs.hpp"
#include "continuum/solver.hpp"
#include "files/checkpoint.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

using namespace continuum;

namespace {

Setup gas_at_rest(const char* scheme = "muscl") {
    Setup setup = cases::tube(32, 8.0, End::wall, End::wall, [](double) { return cases::Point{0.2, 0.0, 1.0}; });
    setup.choices.transport.name = "navier_stokes";
    setup.choices.scheme.name = scheme;
    setup.choices.closure.name = "jenkins_richman_dense";
    return setup;
}

/// Asks for the steps it is told to.
struct Stuck : Evolution {
    explicit Stuck(double step) : Evolution(gas_at_rest()), asked_for(step) {}
    double longest_step() override { return asked_for; }
    double asked_for;
};

/// The layer of chapter 4 under the source's method, on a grid too coarse for its landing.
scene::Scene coarse_layer() {
    scene::Scene scene;
    scene.particles.restitution = scene::RestitutionConstant{0.9};
    scene.number_of_particles = 3937;
    scene.motion = scene::PlateMotion::from_acceleration(3.0, 0.095);
    scene.sample.phases = 20;
    scene.continuum.scheme.name = "ftcs";
    scene.continuum.upper.name = "lid";
    scene.continuum.closure.name = "jenkins_richman_dense";
    scene.continuum.spacing = 0.4;
    return scene;
}

}  // namespace

TEST_CASE("steps that vanish, or are no numbers, end a run with place and time") {
    const double step = GENERATE(1e-9, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN());
    Stuck stuck(step);
    CHECK_THROWS_WITH(advance(stuck, 0.25, 1.0, 1e-6),
                      Contains("below the shortest one of 1e-06") && Contains("at time 0.25") && Contains("height"));
    CHECK(stuck.steps() == 0);
    Stuck slow(1e-3);
    advance(slow, 0.25, 0.26, 1e-6);
    CHECK(slow.steps() == 10);
}

TEST_CASE("ftcs ends where a node is no number, and says which") {
    Setup setup = gas_at_rest("ftcs");
    setup.flow.temperature[static_cast<std::size_t>(setup.grid.first(0)) + 20] = std::nan("");
    Ftcs poisoned(setup);
    CHECK_THROWS_WITH(poisoned.step(0.5, 0.001), Contains("time 0.5") && Contains("height") && Contains("nan"));
}

TEST_CASE("ftcs ends where its differences make energy or mass, instead of a wrong answer") {
    const auto ends = [](double factor) {
        Setup setup = gas_at_rest("ftcs");
        for (std::int64_t i = 0; i < setup.grid.nz / 2; ++i)
            setup.flow.density[static_cast<std::size_t>(setup.grid.first(0) + i)] *= 1.2;
        setup.choices.diffusion_factor = factor;
        Ftcs method(setup);
        advance(method, 0.0, 1.0, 1e-6);
    };
    CHECK_NOTHROW(ends(0.16));
    // Explicit diffusion is unstable beyond 0.75 in this gas: D dt/h^2 = 1/2 with D = 2 kappa/(3 n), kappa the
    // stiffest.
    CHECK_NOTHROW(ends(0.7));
    CHECK_THROWS_WITH(ends(0.85), Contains("time") && Contains("height"));

    Solver solver(coarse_layer());
    CHECK_THROWS_WITH(solver.advance_to_instant(4, 0),
                      Contains("the method has made") && Contains("height") && Contains("in cycle"));
}

TEST_CASE("a frozen gas is named under every scheme, with its place") {
    scene::Scene scene = coarse_layer();
    scene.continuum.scheme.name = GENERATE("muscl", "ftcs");
    scene.continuum.spacing = 0.2;
    scene.particles.restitution = scene::RestitutionConstant{0.6};
    scene.continuum.floor_temperature = 0.5;
    Solver solver(scene);
    CHECK_THROWS_WITH(solver.advance_to_instant(5, 0),
                      Contains("temperature floor 0.5") && Contains("height") && Contains("in cycle"));
}

TEST_CASE("what a failed run leaves stands at the time of its failure") {
    const support::TemporaryFolder folder;
    const auto failure_of = [](Solver& solver) {
        try {
            solver.advance_to_instant(4, 0);
        } catch (const RunFailed& failure) {
            return std::pair(std::string(failure.what()), failure.time);
        }
        return std::pair(std::string(), -1.0);
    };
    Solver failed(coarse_layer());
    const auto [said, time] = failure_of(failed);
    REQUIRE(time > failed.time_in_cycle());
    files::CheckpointWriter writer;
    failed.save(writer);
    writer.commit(folder / "state");
    Solver resumed(coarse_layer());
    resumed.restore(files::CheckpointReader(folder / "state"));
    CHECK(resumed.state_hash() == failed.state_hash());
    // It goes on from there, so it fails no earlier.
    CHECK(failure_of(resumed).second >= time);
}
