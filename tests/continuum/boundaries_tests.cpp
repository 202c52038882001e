// SPDX-License-Identifier: MIT
// Ends by name, against what is known of each.
#include <cmath>

#include "continuum/boundary/named.hpp"
#include "continuum/errors.hpp"
#include "continuum/parameters.hpp"
#include "continuum/solver.hpp"
#include "continuum/verification.hpp"
#include "scene/errors.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

using namespace continuum;

namespace {

scene::Scene tube(const std::vector<std::string>& changes) {
    return continuum::read_scene(SHAKEN_SOURCE_DIR "/data/scenes/verify_riemann.toml", changes);
}

}  // namespace

TEST_CASE("between two heated ends the heat flux of a dilute gas is the same everywhere") {
    // Conductivity of a dilute gas goes as sqrt(T), so T^(3/2) is a straight line.
    const Verification v = verify(
        tube({"tube.lower=\"heated\"", "tube.upper=\"heated\"", "tube.lower_temperature=1.0",
              "tube.upper_temperature=2.0", "initial.left.volume_fraction=1e-5", "initial.right.volume_fraction=1e-5",
              "tube.length=4.0", "tube.time=3.0", "continuum.spacing=0.1", "continuum.transport=\"navier_stokes\""}));
    for (std::size_t i = 0; i < v.height.size(); ++i) {
        const double line = 1.0 + (std::pow(2.0, 1.5) - 1.0) * v.height[i] / 4.0;
        // Truncation: (dz/L)^2 of the second derivative, and 1e-5 of the density in the conductivity.
        CHECK(v.temperature[i] == Approx(std::pow(line, 2.0 / 3.0)).epsilon(2e-3));
    }
}

TEST_CASE("a piston by name is the piston of the kind piston, to the last bit") {
    const Verification named =
        verify(tube({"tube.lower=\"piston\"", "tube.speed=1.5", "initial.left.volume_fraction=0.2",
                     "initial.right.volume_fraction=0.2", "continuum.spacing=0.1"}));
    const Verification kind = verify(
        continuum::read_scene(SHAKEN_SOURCE_DIR "/data/scenes/verify_piston.toml",
                              {"tube.speed=1.5", "tube.length=10.0", "tube.time=0.6", "initial.volume_fraction=0.2",
                               "initial.temperature=1.0", "continuum.spacing=0.1"}));
    CHECK(named.volume_fraction == kind.volume_fraction);
    CHECK(named.velocity == kind.velocity);
    CHECK(named.temperature == kind.temperature);
    CHECK(named.why_no_exact.find("piston") != std::string::npos);
}

TEST_CASE("a plate that takes heat cools the layer, and the books say by how much") {
    const auto after_a_cycle = [](const std::vector<std::string>& changes) {
        const scene::Scene scene = continuum::read_scene(SHAKEN_SOURCE_DIR "/data/scenes/ch4_shock.toml", changes);
        Solver solver(scene);
        solver.advance_to_instant(1, 0);
        return solver.ledger();
    };
    const Ledger closed = after_a_cycle({"continuum.spacing=0.4"});
    const Ledger cold =
        after_a_cycle({"continuum.spacing=0.4", "continuum.lower=\"heated\"", "continuum.lower_temperature=0.1"});
    CHECK(closed.boundary_gain == 0.0);
    CHECK(cold.boundary_gain < 0.0);
    CHECK(cold.energy < closed.energy);
    const double booked = cold.initial_energy + cold.body_force_work - cold.collisional_loss + cold.floor_gain +
                          cold.dual_energy_gain + cold.boundary_gain;
    // Round-off over a thousand steps.
    CHECK(cold.energy == Approx(booked).epsilon(1e-11));
}

TEST_CASE("ends that contradict each other are refused with their place") {
    const auto said = [](const char* scene, const std::vector<std::string>& changes) -> std::string {
        try {
            const scene::Scene read =
                continuum::read_scene(std::string(SHAKEN_SOURCE_DIR "/data/scenes/") + scene, changes);
            if (read.kind == scene::Kind::layer)
                boundaries_of_layer(read.continuum);
            else
                boundaries_of_tube(read.tube);
        } catch (const scene::SceneError& error) {
            return error.what();
        }
        return "";
    };
    CHECK_THAT(said("ch4_shock.toml", {"continuum.lower=\"heatd\""}), Contains("--set") && Contains("did you mean"));
    CHECK_THAT(said("ch4_shock.toml", {"continuum.upper=\"open\""}), Contains("known: stress_free, lid, heated"));
    CHECK_THAT(said("ch4_shock.toml", {"continuum.lower=\"heated\""}), Contains("needs continuum.lower_temperature"));
    CHECK_THAT(said("ch4_shock.toml", {"continuum.upper_temperature=1.0"}),
               Contains("--set continuum.upper_temperature") && Contains("needs continuum.upper"));
    CHECK_THAT(said("verify_riemann.toml", {"tube.lower=\"periodic\""}), Contains("periodic together"));
    CHECK_THAT(said("verify_riemann.toml", {"tube.upper=\"piston\""}), Contains("unknown"));
}
