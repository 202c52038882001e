// SPDX-License-Identifier: MIT
// The stress-free end above a layer: what it bears, and that its height does not matter.

#include <cmath>
#include <numbers>

#include "continuum/closures/closures.hpp"
#include "continuum/parameters.hpp"
#include "continuum/resolve.hpp"
#include "continuum/solver.hpp"
#include "continuum/step/evolution.hpp"
#include "scene/errors.hpp"
#include "scene/read_scene.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

using namespace continuum;

namespace {

/// A dense gas in a box of two dimensions that moves towards its upper end and away from the middle, under `transport`.
Setup rising_gas(End upper, const char* transport) {
    Grid grid;
    grid.nx = 8;
    grid.nz = 16;
    grid.dx = grid.dz = 0.5;
    Setup setup(grid);
    setup.boundaries.upper.end = upper;
    setup.choices.transport.name = transport;
    for (std::int64_t ix = 0; ix < grid.nx; ++ix)
        for (std::int64_t iz = 0; iz < grid.nz; ++iz) {
            const auto i = static_cast<std::size_t>(grid.first(grid.column(ix, 0)) + iz);
            setup.flow.density[i] = 0.4;
            setup.flow.velocity_x[i] = std::sin(2.0 * std::numbers::pi * (static_cast<double>(ix) + 0.5) / 8.0);
            setup.flow.velocity_z[i] = 0.2 * grid.centre(iz) / 8.0;
        }
    return setup;
}

/// Mean normal stress on the upper end in a first step so short that the gas does not change.
double stress_on_upper_end(Setup setup) {
    constexpr double dt = 1e-7;
    Evolution evolution(std::move(setup));
    evolution.step(0.0, dt);
    return evolution.ledger().lid_impulse / dt;
}

/// z_cm in the plate's frame at ten phases of the sixth cycle, and the mean force on the upper end over the weight.
struct Seen {
    std::vector<double> heights;
    double force;
};
Seen shaken_under(double lid, const char* upper) {
    const scene::Scene scene = continuum::read_scene(
        SHAKEN_SOURCE_DIR "/data/scenes/ch5_growth.toml",
        {"continuum.dimension=1", "initial.wave=0.0", "plate.acceleration=3.0", "continuum.spacing=0.5",
         "continuum.lid=" + scene::written_number(lid), "continuum.upper=" + std::string(upper)});
    Solver solver(scene);
    Seen seen;
    solver.advance_to_instant(5, 0);
    const double before = solver.ledger().lid_impulse;
    for (std::int64_t phase = 0; phase < 20; phase += 2) {
        solver.advance_to_instant(5, phase);
        const ColumnView column = solver.column(0, 0);
        double moment = 0.0;
        for (std::size_t i = 0; i < column.density.size(); ++i)
            moment += column.density[i] * (static_cast<double>(i) + 0.5) * solver.spacing_z();
        seen.heights.push_back(moment * solver.spacing_z() / solver.mass());
    }
    solver.advance_to_instant(6, 0);
    seen.force = (solver.ledger().lid_impulse - before) / (scene.motion.period() * solver.mass());
    return seen;
}

double largest_difference(const Seen& one, const Seen& other) {
    double most = 0.0;
    for (std::size_t k = 0; k < one.heights.size(); ++k)
        most = std::max(most, std::abs(one.heights[k] / other.heights[k] - 1.0));
    return most;
}

}  // namespace

TEST_CASE("a stress-free end bears the pressure of a reflecting end and no viscous stress") {
    const double inviscid = stress_on_upper_end(rising_gas(End::wall, "inviscid"));
    CHECK(inviscid > 0.0);
    // The gas changes by dt times its rates: truncation, of order 1e-7 times a hundred.
    CHECK(stress_on_upper_end(rising_gas(End::stress_free, "inviscid")) == inviscid);
    CHECK(stress_on_upper_end(rising_gas(End::stress_free, "navier_stokes")) == Approx(inviscid).epsilon(1e-5));
    CHECK(std::abs(stress_on_upper_end(rising_gas(End::wall, "navier_stokes")) / inviscid - 1.0) > 0.1);
}

TEST_CASE("below a stress-free end gas that parts along x is drawn up by the stress inside, at a wall it is held") {
    Setup parting = rising_gas(End::stress_free, "navier_stokes");
    std::fill(parting.flow.velocity_z.begin(), parting.flow.velocity_z.end(), 0.0);
    const Flow start = parting.flow;
    Evolution evolution(parting);
    constexpr double dt = 1e-7;
    evolution.step(0.0, dt);
    const Grid& grid = evolution.grid();
    const Transport at = JenkinsRichman::transport<Goldshtein>(0.4, 1.0, 1.0);
    for (std::int64_t ix = 0; ix < 8; ++ix) {
        const auto lowest = [&](std::int64_t x) { return static_cast<std::size_t>(grid.first((x + 8) % 8)); };
        const double divergence =
            (start.velocity_x[lowest(ix + 1)] - start.velocity_x[lowest(ix - 1)]) / (2.0 * grid.dx);
        const double stress = (at.bulk_viscosity - (2.0 / 3.0) * at.shear_viscosity) * divergence;
        const double drawn = -dt * stress / (0.4 * grid.dz);
        // Of order dt: the pressure that a first step changes.
        CHECK(evolution.flow().velocity_z[lowest(ix) + 15] == Approx(drawn).margin(1e-13));
        CHECK(std::abs(evolution.flow().velocity_z[lowest(ix)]) < 1e-13);
    }
}

TEST_CASE("the height of a stress-free end does not change a layer that does not reach it, that of a lid does") {
    const Seen low = shaken_under(25.0, "stress_free"), high = shaken_under(50.0, "stress_free");
    // Truncation: the gas above decides the steps. 1.2e-4 at cfl 0.8; 8e-5 where cfl 0.2 leaves 2e-6 (ch5_growth, dz 0.5).
    CHECK(largest_difference(low, high) < 2e-4);
    CHECK(std::abs(low.force) < 1e-5);
    CHECK(largest_difference(shaken_under(25.0, "lid"), shaken_under(50.0, "lid")) > 1e-3);
}

TEST_CASE("a layer that names no upper end has a stress-free one, under ftcs the source's wall") {
    const auto upper = [](const std::vector<std::string>& changes) {
        const scene::Scene scene = continuum::read_scene(SHAKEN_SOURCE_DIR "/data/scenes/ch4_shock.toml", changes);
        return continuum::resolve(scene).continuum.upper.name;
    };
    CHECK(upper({}) == "stress_free");
    CHECK(upper({"continuum.scheme=weno5"}) == "stress_free");
    CHECK(upper({"continuum.scheme=ftcs", "continuum.closure=jenkins_richman_dense"}) == "lid");
    CHECK(upper({"continuum.upper=lid"}) == "lid");
    const scene::Scene asked = continuum::read_scene(
        SHAKEN_SOURCE_DIR "/data/scenes/ch4_shock.toml",
        {"continuum.scheme=ftcs", "continuum.closure=jenkins_richman_dense", "continuum.upper=stress_free"});
    CHECK_THROWS_WITH(Solver(asked), Contains("--set continuum.upper") && Contains("ftcs"));
}
