// SPDX-License-Identifier: MIT
// One centre of mass, two ways: the mean of a map, weighted by the mass of its bins, is z_cm of the same instant.
#include <cmath>

#include "compare/continuum_sampler.hpp"
#include "compare/md_sampler.hpp"
#include "compare/scenes.hpp"
#include "synthetic.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

/// 6 x 5 columns, as many along neither axis.
scene::Scene oblong() {
    return compare::parse_scene(R"(
[plate]
acceleration = 3.0
frequency = 0.15
[particles]
number = 600
restitution = 0.9
[box]
x = 12.0
y = 10.0
[initial]
wave = 0.3
wave_x = 1
wave_y = 1
[sample]
phases = 20
settle = 0
average = 2
maps = 20
map_bin = 2.0
[continuum]
dimension = "3"
spacing = 0.5
spacing_horizontal = 2.0
lid = 30.0
)",
                                "oblong.toml");
}

}  // namespace

TEST_CASE("the mean of a map of particles, weighted by their number, is their centre of mass") {
    const scene::Scene scene = oblong();
    synthetic::Normal normal(4);
    for (const std::int64_t phase : {0, 7}) {
        md::Snapshot state;
        for (int i = 0; i < 600; ++i) {
            state.position.push_back({6.0 + 2.0 * normal(), 5.0 + 1.5 * normal(), 20.0 + 3.0 * normal()});
            state.velocity.push_back({});
        }
        compare::MdSampler sampler(scene);
        sampler.sample(state, {0, phase});
        const auto& grid = sampler.maps().grid();
        REQUIRE(grid.nx == 6);
        REQUIRE(grid.ny == 5);
        std::vector<double> number(grid.size(), 0.0), moment(grid.size(), 0.0);
        for (const auto& r : state.position) {
            const auto wrapped = [](double x, double length) { return x - length * std::floor(x / length); };
            const auto bin = static_cast<std::size_t>(wrapped(r[0], 12.0) / 2.0) +
                             6 * static_cast<std::size_t>(wrapped(r[1], 10.0) / 2.0);
            number[bin] += 1.0;
            moment[bin] += r[2];
        }
        const std::vector<double> map = sampler.maps().row(0);
        double mean = 0.0;
        for (std::size_t bin = 0; bin < map.size(); ++bin) {
            if (number[bin] > 0.0) CHECK(map[bin] == Approx(moment[bin] / number[bin]).epsilon(1e-13));  // round-off
            mean += number[bin] * map[bin] / 600.0;
        }
        CHECK(mean == Approx(sampler.moments().mean_centre_of_mass(phase).first).epsilon(1e-13));
    }
}

TEST_CASE("the mean of a map of columns, weighted by their mass, is the continuum's centre of mass") {
    scene::Scene scene = oblong();
    scene.sample.map_bin = GENERATE(2.0, 4.0);  // bins of one column, or of two along x and two and a half along y
    continuum::Solver solver(scene);
    compare::ContinuumSampler sampler(scene, 0.5);
    std::size_t row = 0;
    for (const std::int64_t phase : {0, 7}) {
        solver.advance_to_instant(0, phase);
        sampler.sample(solver, {0, phase});
        const auto& grid = sampler.maps().grid();
        std::vector<double> mass(grid.size(), 0.0);
        double whole = 0.0;
        for (std::int64_t iy = 0; iy < solver.cells_y(); ++iy)
            for (std::int64_t ix = 0; ix < solver.cells_x(); ++ix) {
                double column = 0.0;
                for (const double n : solver.column(ix, iy).density) column += n;
                whole += column;
                for (std::int64_t by = 0; by < grid.ny; ++by)
                    for (std::int64_t bx = 0; bx < grid.nx; ++bx) {
                        const auto shared = [](double lower, double side, double bin_lower, double bin_side) {
                            return std::max(0.0,
                                            std::min(lower + side, bin_lower + bin_side) - std::max(lower, bin_lower)) /
                                   side;
                        };
                        mass[static_cast<std::size_t>(by * grid.nx + bx)] +=
                            column *
                            shared(2.0 * static_cast<double>(ix), 2.0, grid.dx() * static_cast<double>(bx), grid.dx()) *
                            shared(2.0 * static_cast<double>(iy), 2.0, grid.dy() * static_cast<double>(by), grid.dy());
                    }
            }
        const std::vector<double> map = sampler.maps().row(row++);
        double mean = 0.0, highest = map[0], lowest = map[0];
        for (std::size_t bin = 0; bin < map.size(); ++bin) {
            mean += mass[bin] * map[bin] / whole;
            highest = std::max(highest, map[bin]);
            lowest = std::min(lowest, map[bin]);
        }
        // Round-off, and bins that are taken to end at a column's edge to 1e-9 of it.
        CHECK(mean == Approx(sampler.moments().mean_centre_of_mass(phase).first).epsilon(1e-9));
        if (phase > 0) CHECK(highest - lowest > 1e-3);  // the wave is there
    }
}
