// SPDX-License-Identifier: MIT
#include "continuum/initial_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "continuum/boundary/named.hpp"
#include "continuum/closures/pressure.hpp"
#include "continuum/ftcs/ftcs.hpp"
#include "continuum/initial_file.hpp"
#include "continuum/kernels.hpp"
#include "continuum/resolve.hpp"
#include "scene/errors.hpp"
#include "scene/random_stream.hpp"

namespace shaken::continuum {

namespace {

/// One factor a column, mean 1: noise and one wave.
std::vector<double> column_factors(const Grid& grid, const scene::Initial& initial) {
    std::vector<double> factors(static_cast<std::size_t>(grid.columns()), 1.0);
    if (!initial.uneven() || grid.columns() == 1) return factors;
    scene::RandomStream random(initial.seed);
    const double turn_x = static_cast<double>(initial.wave_x) / static_cast<double>(grid.nx);
    const double turn_y = static_cast<double>(initial.wave_y) / static_cast<double>(grid.ny);
    double sum = 0.0;
    for (std::int64_t column = 0; column < grid.columns(); ++column) {
        const double turns = turn_x * (static_cast<double>(column % grid.nx) + 0.5) +
                             turn_y * (static_cast<double>(column / grid.nx) + 0.5);
        double& factor = factors[static_cast<std::size_t>(column)];
        factor =
            1.0 + initial.noise * random.uniform(-1.0, 1.0) + initial.wave * scene::sine_cosine_of_turns(turns).cosine;
        sum += factor;
    }
    for (double& factor : factors) factor *= static_cast<double>(factors.size()) / sum;
    return factors;
}

/// 1 inside the layer and exp(-(z - top)/T) above, as of a gas at rest, with the top lowered so that mass is kept.
double share_below_soft_top(double z, double height, double temperature) {
    const double top = std::max(0.0, height - temperature);
    return z < top ? 1.0 : scene::exponential((top - z) / temperature);
}

/// The stored state on this grid, its mass made that of the scene.
void fill_from_file(Setup& setup, const scene::Scene& scene, const std::vector<double>& factors, double floor,
                    double packing) {
    const Grid& grid = setup.grid;
    const StoredFlow stored = read_flow(scene.initial.file, scene.initial.phase);
    double sum = 0.0;
    for (std::int64_t column = 0; column < grid.columns(); ++column)
        for (std::int64_t iz = 0; iz < grid.nz; ++iz) {
            const Interpolated at = interpolate(stored, grid, column % grid.nx, column / grid.nx, iz);
            const auto i = static_cast<std::size_t>(grid.first(column) + iz);
            setup.flow.density[i] = factors[static_cast<std::size_t>(column)] * at.density;
            setup.flow.velocity_x[i] = grid.nx > 1 || grid.ny > 1 ? at.velocity_x : 0.0;
            setup.flow.velocity_y[i] = grid.nx > 1 || grid.ny > 1 ? at.velocity_y : 0.0;
            setup.flow.velocity_z[i] = at.velocity_z;
            setup.flow.temperature[i] = std::max(at.temperature, setup.floor_temperature);
            sum += setup.flow.density[i];
        }
    const double stored_number = sum * grid.dz / static_cast<double>(grid.columns());
    const double share = scene.number_per_area() / stored_number;
    if (!(share > 0.9 && share < 1.1))
        throw scene::SceneError({},
                                fmt::format("initial.file: {} holds {:.5g} particles a unit area below the lid, the "
                                            "scene has {:.5g}",
                                            scene.initial.file, stored_number, scene.number_per_area()));
    double densest = 0.0;
    for (std::int64_t column = 0; column < grid.columns(); ++column)
        for (std::int64_t iz = 0; iz < grid.nz; ++iz) {
            double& n = setup.flow.density[static_cast<std::size_t>(grid.first(column) + iz)];
            n = std::max(share * n, floor);
            densest = std::max(densest, n);
        }
    if (densest * sphere_volume >= packing)
        throw scene::SceneError({},
                                fmt::format("initial.file: volume fraction {:.4g} is not below {}, where {} packs",
                                            densest * sphere_volume, packing, scene.continuum.pair_correlation.name));
}

}  // namespace

Grid make_grid(const scene::Scene& scene) {
    const int dimension = resolve_dimension(scene);
    const scene::Continuum& c = scene.continuum;
    const auto cells = [](double length, double spacing) {
        return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::llround(length / spacing)));
    };
    Grid grid;
    grid.nz = cells(c.lid, c.spacing);
    grid.dz = c.lid / static_cast<double>(grid.nz);
    const bool along_x = dimension == 3 || (dimension == 2 && scene.box.x >= scene.box.y);
    const bool along_y = dimension == 3 || (dimension == 2 && !along_x);
    grid.nx = along_x ? cells(scene.box.x, c.spacing_horizontal) : 1;
    grid.ny = along_y ? cells(scene.box.y, c.spacing_horizontal) : 1;
    grid.dx = scene.box.x / static_cast<double>(grid.nx);
    grid.dy = scene.box.y / static_cast<double>(grid.ny);
    if (grid.nz < 16)
        throw scene::SceneError(
            {}, fmt::format("continuum.lid / continuum.spacing gives {} cells; at least 16 are needed", grid.nz));
    return grid;
}

int resolve_dimension(const scene::Scene& scene) {
    const scene::Choice& choice = scene.continuum.dimension;
    if (choice.name == "1" || choice.name == "2" || choice.name == "3") return choice.name[0] - '0';
    if (choice.name != "auto") throw scene::unknown_choice("continuum.dimension", choice, {"auto", "1", "2", "3"});
    if (!scene.initial.uneven()) return 1;
    return std::min(scene.box.x, scene.box.y) < 2.0 * scene.depth ? 2 : 3;
}

Setup make_setup(const scene::Scene& given) {
    if (given.kind != scene::Kind::layer)
        throw scene::SceneError({}, "a scene of this kind has no layer; it is run by: shaken continuum");
    const scene::Scene scene = resolve(given);
    const Grid grid = make_grid(scene);
    Setup setup(grid);
    setup.choices = scene.continuum;
    setup.motion = scene.motion;
    setup.gravity = 1.0;
    setup.boundaries = boundaries_of_layer(scene.continuum);
    setup.sink = sink_restitution(scene);
    setup.restitution = pressure_restitution(scene);
    setup.floor_temperature = scene.continuum.floor_temperature;

    const double packing = choose_kernels(scene.continuum).packing;
    const double mean_density = scene.number_per_area() / scene.continuum.lid;
    const double floor = scene.continuum.floor_density * mean_density;
    const double density = scene.initial.volume_fraction / sphere_volume;
    const std::vector<double> factors = column_factors(grid, scene.initial);
    if (!scene.initial.file.empty()) {
        fill_from_file(setup, scene, factors, floor, packing);
        return setup;
    }
    const double densest = density * *std::max_element(factors.begin(), factors.end());
    if (densest * sphere_volume >= packing)
        throw scene::SceneError(
            {}, fmt::format("initial.volume_fraction = {} (with noise {}) is not below {}, where {} packs",
                            scene.initial.volume_fraction, scene.initial.noise, packing,
                            scene.continuum.pair_correlation.name));
    const double height = scene.number_per_area() / density;
    if (height > scene.continuum.lid)
        throw scene::SceneError(
            {}, fmt::format("the layer starts {:.4g} high and does not fit below continuum.lid = {}", height,
                            scene.continuum.lid));
    const bool soft_top = scene.continuum.scheme.name == Ftcs::name;
    for (std::int64_t column = 0; column < grid.columns(); ++column) {
        const double factor = factors[static_cast<std::size_t>(column)];
        for (std::int64_t iz = 0; iz < grid.nz; ++iz) {
            const double filled = soft_top ? share_below_soft_top(grid.centre(iz), height, scene.initial.temperature)
                                           : std::clamp(height / grid.dz - static_cast<double>(iz), 0.0, 1.0);
            const auto i = static_cast<std::size_t>(grid.first(column) + iz);
            setup.flow.density[i] = std::max(factor * filled * density, floor);
            setup.flow.temperature[i] = scene.initial.temperature;
        }
    }
    return setup;
}

}  // namespace shaken::continuum
