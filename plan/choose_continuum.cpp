// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "plan/choices.hpp"
#include "plan/levels.hpp"
#include "plan/rules.hpp"
#include "plan/table.hpp"

namespace shaken::plan {

namespace {

// Parts of one error that may have one sign.
constexpr double share_of_grid = 0.4, share_of_lid = 0.35, share_of_start = 0.25;
constexpr double coarsest = 1.6;            // sigma; every level is half the one before
constexpr double least_cells_in_layer = 5;  // as poured: with fewer there is no profile
constexpr int most_levels = 8;
constexpr double least_cells = 16;  // the solver's own limit
constexpr double settled_for_trial = 0.005;
constexpr double base_lid_error = 0.01;  // of the lid that all grids are tried under; errors of grid and lid are apart
constexpr std::size_t whole_runs = 8;  // lengths of trials are multiples of this many cycles, so that they serve again
constexpr std::array lids{20.0, 25.0, 32.0, 40.0, 50.0, 60.0, 80.0, 100.0, 125.0, 160.0, 200.0, 250.0, 320.0, 400.0};
constexpr double bytes_a_cell_of_column = 188, bytes_a_cell = 220;  // bench/continuum.md
constexpr double horizontal_error = 0.0014;                         // dx = 2 to 7 at figure 3.3, docs/numerics.md

constexpr const char* no_grid =
    "plan: the continuum fails on every grid tried; see what it says with: shaken continuum";

double first_level(const scene::Scene& scene) {
    double spacing = coarsest;
    while (spacing > scene.depth / least_cells_in_layer) spacing *= 0.5;
    return spacing;
}

/// The first level on which the method goes through.
double first_running_level(Trials& trials, const std::string& scheme, double lid) {
    double spacing = first_level(trials.scene());
    for (int level = 0; level < most_levels; ++level, spacing *= 0.5)
        if (trials.under_lid(scheme, spacing, lid)) return spacing;
    throw CannotPlan(no_grid);
}

Profile late(const Heights& heights) { return mean(heights, heights.size() / 2, heights.size()); }

/// The lowest lid whose z_cm is within the error of the highest's, and its deviation from that.
std::pair<double, Profile> choose_lid(Trials& trials, const std::string& scheme, double spacing, double error) {
    const Profile highest = late(*trials.under_lid(scheme, spacing, lids.back()));
    const auto off = [&](std::size_t k) -> std::optional<Profile> {
        if (lids[k] < least_cells * spacing) return std::nullopt;
        const Heights* tried = trials.under_lid(scheme, spacing, lids[k]);
        return tried ? std::optional(deviation(late(*tried), highest)) : std::nullopt;
    };
    std::size_t low = 0, high = lids.size() - 1;
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        const std::optional<Profile> found = off(middle);
        if (found && root_mean_square(*found) <= error)
            high = middle;
        else
            low = middle + 1;
    }
    return {lids[high], off(high).value_or(Profile{})};
}

/// Grids each half as wide as the one before, until the error or the trials' time is reached; errors from the finest.
std::vector<Level> measure_levels(Trials& trials, const ContinuumPlan& plan, double lid, double spacing, double error,
                                  double order) {
    const auto settle = static_cast<std::size_t>(plan.settle);
    const std::size_t cycles = settle + static_cast<std::size_t>(plan.average);
    const std::size_t run = (cycles + whole_runs - 1) / whole_runs * whole_runs;
    std::vector<Level> levels;
    for (int k = 0; k < most_levels; ++k, spacing *= 0.5) {
        const Column* column = trials.column(plan.scheme, spacing, lid, run, levels.size() < 2);
        if (!column) {
            if (levels.empty()) continue;
            break;
        }
        levels.push_back({spacing, 0.0, column->seconds_per_cycle, column->steps_per_cycle, column->seconds_to_begin,
                          column->seconds_to_leave, mean(column->heights, settle, cycles)});
        tell_errors(levels, order);
        if (levels.size() > 1 && levels.back().error <= 0.5 * error) break;
    }
    return levels;
}

double cells_along(double side, double spacing) { return std::max(1.0, std::round(side / spacing)); }

/// Time and memory of the full grid; of one column they are the level's own.
void put_cost(Trials& trials, ContinuumPlan& plan, double fixed, double seconds_a_cycle, double steps_a_cycle) {
    const scene::Scene& scene = trials.scene();
    const double rows = std::round(plan.lid / plan.spacing);
    const auto cycles = static_cast<double>(plan.settle + plan.average);
    if (plan.dimension == 1) {
        plan.seconds = fixed + seconds_a_cycle * cycles;
        plan.bytes = bytes_a_cell_of_column * rows;
        return;
    }
    double cells = rows;
    if (plan.dimension == 3 || scene.box.x >= scene.box.y) cells *= cells_along(scene.box.x, plan.spacing_horizontal);
    if (plan.dimension == 3 || scene.box.x < scene.box.y) cells *= cells_along(scene.box.y, plan.spacing_horizontal);
    plan.seconds = fixed + trials.seconds_per_update(planned_scene(scene, plan)) * cells * steps_a_cycle * cycles;
    plan.bytes = bytes_a_cell * cells;
}

}  // namespace

double ContinuumPlan::error() const {
    // Parts measured on coarse grids may have the other sign on the planned one: what cancels there is not counted on.
    const double apart = std::sqrt(grid * grid + lid_error * lid_error + start * start);
    const double parts = std::max(root_mean_square(together), apart);
    return std::sqrt(parts * parts + columns * columns + scatter * scatter + floor * floor);
}

scene::Scene planned_scene(const scene::Scene& given, const ContinuumPlan& plan) {
    scene::Scene scene = given;
    scene.continuum.dimension.name = fmt::format("{}", plan.dimension);
    scene.continuum.scheme.name = plan.scheme;
    scene.continuum.spacing = plan.spacing;
    scene.continuum.lid = plan.lid;
    if (plan.dimension > 1) scene.continuum.spacing_horizontal = plan.spacing_horizontal;
    return scene;
}

ContinuumPlan choose_continuum(Trials& trials, double error) {
    const Scheme& scheme = measured_table().cheapest(0.5 * error);
    const scene::Scene& scene = trials.scene();
    const double order = std::clamp(scheme.error.order, 1.0, 2.0);
    ContinuumPlan plan;
    plan.scheme = scheme.name;
    plan.dimension = needed_dimension(scene);
    const double highest = lids.back();
    const double spacing = first_running_level(trials, plan.scheme, highest);
    const double base = choose_lid(trials, plan.scheme, spacing, base_lid_error).first;
    const auto [lid, off_lid] = choose_lid(trials, plan.scheme, spacing, share_of_lid * error);
    plan.lid = lid;
    plan.lid_error = root_mean_square(off_lid);

    const auto roughly = settling_time(*trials.under_lid(plan.scheme, spacing, base), settled_for_trial);
    const std::int64_t own = plan.dimension > 1 ? scene.sample.settle : 0;
    plan.settle_of_trial = std::clamp<std::int64_t>(std::max(own, static_cast<std::int64_t>(roughly)), 4, 24);
    const Heights& long_run = *trials.under_lid(plan.scheme, spacing, plan.lid);
    const double noise = spread(long_run, long_run.size() / 2).value;
    const auto settle = settling_time(long_run, std::max(share_of_start * error, 2.0 * noise));
    plan.settle = static_cast<std::int64_t>(std::max<std::size_t>(2, settle));
    if (plan.dimension > 1) plan.settle = std::max(plan.settle, scene.sample.settle);
    const double cycles = std::min(1000.0, std::ceil(std::pow(noise / (0.5 * error), 2)));
    plan.average = std::max<std::int64_t>(2, 2 * std::llround(std::ceil(0.5 * cycles)));
    plan.scatter = noise / std::sqrt(static_cast<double>(plan.average));
    const Profile off_start =
        left_of_start(long_run, static_cast<std::size_t>(plan.settle), static_cast<std::size_t>(plan.average));
    plan.start = root_mean_square(off_start);
    if (plan.dimension > 1) {
        const double longest = std::max(scene.box.x, scene.box.y);
        plan.spacing_horizontal =
            longest / std::ceil(longest / (pattern_wavelength(scene) / cells_a_wavelength) - 1e-9);
        plan.columns = horizontal_error;
    }

    const std::vector<Level> levels = measure_levels(trials, plan, base, spacing, share_of_grid * error, order);
    for (int k = 0; k < 2 * most_levels; ++k) {
        const double level = levels.front().spacing / std::pow(2.0, k / 2);
        plan.spacing = k % 2 == 0 ? level : 0.75 * level;
        plan.grid = interpolate(levels, plan.spacing, &Level::error, order);
        if (plan.grid <= share_of_grid * error && plan.spacing <= plan.lid / least_cells) break;
    }
    plan.floor = scheme.least_error;
    plan.together = sum_of(sum_of(deviation_at(levels, plan.spacing, plan.grid), off_lid), off_start);
    put_cost(trials, plan, trials.start_of_program() + levels.front().begin + plan.lid / base * levels.front().leave,
             plan.lid / base * interpolate(levels, plan.spacing, &Level::seconds, -2.0),
             interpolate(levels, plan.spacing, &Level::steps, -1.0));
    return plan;
}

}  // namespace shaken::plan
