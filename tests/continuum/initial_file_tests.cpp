// SPDX-License-Identifier: MIT
// Starts from an earlier state, onto other grids.
#include <cmath>
#include <numbers>

#include "continuum/initial_file.hpp"
#include "continuum/parameters.hpp"
#include "fields/phase_moments.hpp"
#include "files/hdf5.hpp"
#include "files/provenance.hpp"
#include "scene/read_scene.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/command.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

using namespace continuum;

TEST_CASE("a stored state comes back exactly on its own grid, and to second order on another") {
    StoredFlow stored;
    stored.cells = {8, 4, 32};
    stored.spacing = {1.0, 2.0, 0.5};
    const auto value = [](double x, double z) {
        return 1.0 + 0.3 * std::cos(2.0 * std::numbers::pi * x / 8.0) + 0.1 * z;
    };
    for (int iz = 0; iz < 32; ++iz)
        for (int iy = 0; iy < 4; ++iy)
            for (int ix = 0; ix < 8; ++ix) stored.density.push_back(value(ix + 0.5, 0.5 * (iz + 0.5)));
    stored.velocity_x = stored.velocity_y = stored.velocity_z = stored.temperature = stored.density;
    Grid same;
    same.nx = 8;
    same.ny = 4;
    same.nz = 32;
    same.dy = 2.0;
    same.dz = 0.5;
    for (std::int64_t iz = 0; iz < 32; ++iz)
        for (std::int64_t ix = 0; ix < 8; ++ix)
            CHECK(interpolate(stored, same, ix, 2, iz).temperature ==
                  Approx(value(static_cast<double>(ix) + 0.5, same.centre(iz))).epsilon(1e-14));
    Grid finer = same;
    finer.nx = 16;
    finer.dx = 0.5;
    // Linear interpolation: error h^2/8 of the second derivative, 0.3 (2 pi/8)^2 / 8 = 0.023; exact in z.
    double worst = 0.0;
    for (std::int64_t ix = 0; ix < 16; ++ix)
        worst = std::max(worst, std::abs(interpolate(stored, finer, ix, 0, 7).density -
                                         value(0.5 * (static_cast<double>(ix) + 0.5), finer.centre(7))));
    CHECK(worst < 0.023);
    CHECK(worst > 0.001);
    // Nothing above what was stored.
    Grid higher = same;
    higher.nz = 64;
    CHECK(interpolate(stored, higher, 3, 1, 60).density == 0.0);
}

TEST_CASE("a start from the profile of a layer of period two has one flow, that of its higher cycle") {
    constexpr std::int64_t cycles = 12;
    const bool odd_is_higher = GENERATE(false, true);
    fields::PhaseMoments moments(fields::Deposits::cells, 2, {0.0, 1.0, 8}, 1.0, cycles, cycles);
    for (std::int64_t cycle = 0; cycle < cycles; ++cycle)
        for (std::int64_t phase = 0; phase < 2; ++phase) {
            const bool high = (cycle % 2 == 1) == odd_is_higher;
            moments.begin_sample(cycle, phase);
            moments.add_slab(high ? 4.0 : 0.0, high ? 6.0 : 2.0, 0.5, {0.0, 0.0, high ? 3.0 : -1.0}, 0.25);
            moments.set_centre_of_mass(high ? 5.0 : 1.0);
        }
    const support::TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "md.h5";
    {
        files::Hdf5File file(path, files::Open::create);
        files::write_provenance(file, {scene::print_scene(continuum::read_scene(support::small_scene)), 1, ""});
        moments.write(file, "/profiles");
        file.close();
    }
    const StoredFlow flow = read_flow(path, 0.0);
    CHECK(flow.density == std::vector<double>{0.0, 0.0, 0.0, 0.0, 0.5, 0.5, 0.0, 0.0});
    // The plate rests at ft = 0. Round-off of sums over cycles; averaged together T would be 1.6 and u 1.
    CHECK(flow.temperature[4] == Approx(0.25).epsilon(1e-12));
    CHECK(flow.velocity_z[4] == Approx(3.0).epsilon(1e-12));
}
