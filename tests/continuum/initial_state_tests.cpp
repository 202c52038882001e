// SPDX-License-Identifier: MIT
// The state that a scene starts from: its wave on columns that are no square, and what an earlier run left.
#include <cmath>
#include <numbers>

#include "continuum/initial_state.hpp"
#include "continuum/solver.hpp"
#include "fields/field_file.hpp"
#include "fields/phase_moments.hpp"
#include "files/provenance.hpp"
#include "scene/read_scene.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

using namespace continuum;

namespace {

/// 6 columns along x and 8 along y, which are not as wide: no index can stand for another.
scene::Scene oblong() {
    scene::Scene scene;
    scene.box.x = 12.0;
    scene.box.y = 15.0;
    scene.particles.number = scene.number_of_particles = 6 * 12 * 15;
    scene.depth = 5.4;
    scene.plate.acceleration = 2.2;
    scene.plate.frequency = 0.18;
    scene.motion = scene::PlateMotion::from_acceleration(2.2, 0.18);
    scene.continuum.dimension = {"3", {}};
    scene.continuum.spacing = 0.5;
    scene.continuum.lid = 20.0;
    scene.sample.phases = 20;
    return scene;
}

constexpr std::int64_t instant = 7;  // of twenty: the plate moves
constexpr double stored_velocity = -1.7, stored_temperature = 0.8, stored_height = 12.0;

double plate_velocity(const scene::Scene& scene) {
    return scene.motion.velocity(static_cast<double>(instant) / 20.0 * scene.motion.period());
}

/// A slab of one velocity in the lab at that instant, averaged as a run leaves it, bins as wide as the cells.
void write_profile(const scene::Scene& scene, const std::filesystem::path& path) {
    fields::PhaseMoments moments(fields::Deposits::cells, 20, {0.0, 0.5, 40}, scene.box.x * scene.box.y, 1, 1);
    for (std::int64_t phase = 0; phase < 20; ++phase) {
        moments.begin_sample(0, phase);
        moments.add_slab(0.0, stored_height, 6.0 / stored_height, {0.0, 0.0, phase == instant ? stored_velocity : 9.0},
                         stored_temperature);
    }
    files::Hdf5File file(path, files::Open::create);
    files::write_provenance(file, {scene::print_scene(scene), 1, ""});
    moments.write(file, "/profiles");
    file.close();
}

/// The same as frames of columns.
void write_frames(const scene::Scene& scene, const std::filesystem::path& path) {
    files::Hdf5File file(path, files::Open::create);
    files::write_provenance(file, {scene::print_scene(scene), 1, ""});
    const fields::Grid grid{{6, 8, 40}, {2.0, 1.875, 0.5}};
    fields::FieldFile frames(file, path, grid);
    std::vector<double> density, x, y, z, temperature;
    for (std::int64_t iz = 0; iz < 40; ++iz)
        for (std::int64_t column = 0; column < 48; ++column) {
            density.push_back(iz < 24 ? 6.0 / stored_height : 0.0);
            x.push_back(0.1 * static_cast<double>(column % 6));
            y.push_back(0.1 * static_cast<double>(column / 6));
            z.push_back(stored_velocity);
            temperature.push_back(stored_temperature);
        }
    frames.add_frame(
        0.0, 3, static_cast<double>(instant) / 20.0, 0.0,
        {{"density", density}, {"velocity_x", x}, {"velocity_y", y}, {"velocity_z", z}, {"temperature", temperature}});
    file.close();
}

}  // namespace

TEST_CASE("a start's wave is (wave_x, wave_y) on columns that are as many and as wide along neither axis") {
    scene::Scene scene = oblong();
    scene.initial.wave = 0.2;
    scene.initial.wave_x = 1;
    scene.initial.wave_y = 2;
    const Setup setup = make_setup(scene);
    const Grid& grid = setup.grid;
    REQUIRE(grid.nx == 6);
    REQUIRE(grid.ny == 8);
    CHECK(grid.dx == 2.0);
    CHECK(grid.dy == 1.875);
    const double density = scene.initial.volume_fraction * 6.0 / std::numbers::pi;
    for (std::int64_t iy = 0; iy < grid.ny; ++iy)
        for (std::int64_t ix = 0; ix < grid.nx; ++ix) {
            const double x = (static_cast<double>(ix) + 0.5) * grid.dx, y = (static_cast<double>(iy) + 0.5) * grid.dy;
            const double wave = std::cos(2.0 * std::numbers::pi * (x / scene.box.x + 2.0 * y / scene.box.y));
            // Round-off of an angle of up to three turns.
            CHECK(setup.flow.density[static_cast<std::size_t>(grid.first(grid.column(ix, iy)))] ==
                  Approx(density * (1.0 + 0.2 * wave)).epsilon(1e-13));
        }
}

TEST_CASE("noise of a start has its mean nought, and another for another seed") {
    scene::Scene scene = oblong();
    scene.initial.noise = 0.3;
    const auto lowest = [&](std::uint64_t seed) {
        scene.initial.seed = seed;
        const Setup setup = make_setup(scene);
        std::vector<double> n;
        for (std::int64_t column = 0; column < setup.grid.columns(); ++column)
            n.push_back(setup.flow.density[static_cast<std::size_t>(setup.grid.first(column))]);
        return n;
    };
    const std::vector<double> one = lowest(1);
    CHECK(lowest(1) == one);
    CHECK(lowest(2) != one);
    double sum = 0.0;
    for (const double n : one) sum += n;
    CHECK(sum / 48.0 ==
          Approx(scene.initial.volume_fraction * 6.0 / std::numbers::pi).epsilon(1e-13));  // round-off of 48
}

TEST_CASE("a run that starts from profiles or frames has their velocity in the lab at its first sample") {
    const bool profile = GENERATE(true, false);
    scene::Scene scene = oblong();
    const support::TemporaryFolder folder;
    const auto path = folder / "earlier.h5";
    profile ? write_profile(scene, path) : write_frames(scene, path);
    scene.initial.file = path.string();
    scene.initial.phase = static_cast<double>(instant) / 20.0;
    const Solver solver(scene);
    CHECK(solver.cycle() == 0);
    CHECK(solver.phase_index() == instant);
    REQUIRE(plate_velocity(scene) > 1.0);
    for (const std::int64_t ix : {0, 4}) {
        const ColumnView column = solver.column(ix, 5);
        for (std::size_t k = 0; k < 23; ++k) {  // below the edge of the slab; round-off
            CHECK(column.velocity_z[k] + plate_velocity(scene) == Approx(stored_velocity).epsilon(1e-13));
            CHECK(column.velocity_x[k] == Approx(profile ? 0.0 : 0.1 * static_cast<double>(ix)).margin(1e-15));
            CHECK(column.velocity_y[k] == Approx(profile ? 0.0 : 0.5).margin(1e-15));
            CHECK(column.temperature[k] == Approx(stored_temperature).epsilon(1e-13));
            CHECK(column.density[k] == Approx(6.0 / stored_height).epsilon(1e-6));  // above it stands the density floor
        }
    }
}
