// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <thread>

#include "plan/choices.hpp"
#include "plan/rules.hpp"

namespace shaken::plan {

namespace {

constexpr std::int64_t block_cycles = 10;  // the engines keep ten blocks of cycles for their standard errors
constexpr double share_of_settling = 0.2;  // of a seed's cycles, at most, before another seed is worth its start
constexpr double share_of_cell = 0.4, share_of_statistics = 0.85;
constexpr double bytes_a_bin =
    1120;  // ten blocks of seven moments, of all and of odd cycles (fields/phase_moments.hpp)
constexpr double largest_trial = 20000;  // particles

/// The scene in that cell, or in a part of it: a flat layer's spread falls as one over the root of the area, its time
/// grows with the particles.
scene::Scene trial_of(const scene::Scene& given, const ContinuumPlan& continuum, const FlatBox& cell) {
    scene::Scene trial = planned_scene(given, continuum);
    const double shrink = std::sqrt(std::min(1.0, largest_trial / static_cast<double>(cell.number)));
    trial.number_of_particles = std::llround(shrink * shrink * static_cast<double>(cell.number));
    trial.box.x = cell.x * shrink;
    trial.box.y = cell.y * shrink;
    return trial;
}

}  // namespace

double MdPlan::error() const { return std::hypot(std::hypot(statistics, start), std::hypot(cell, drift)); }

MdPlan choose_md(Trials& trials, const ContinuumPlan& continuum, double error) {
    const scene::Scene& given = trials.scene();
    MdPlan plan;
    plan.settle = continuum.settle;
    const bool flat = continuum.dimension == 1;
    const FlatBox whole{given.number_of_particles, given.box.x, given.box.y};
    FlatBox small = flat ? flat_box(given) : whole;
    // One trial that goes through says little: two of six seeds did.
    plan.small_cell_may_collapse = small.number < whole.number && may_collapse(given);
    if (plan.small_cell_may_collapse) small = whole;
    const Grains* tried =
        trials.grains(trial_of(given, continuum, small), continuum.settle_of_trial, plan.small_cell_may_collapse);
    if (!tried) {
        plan.small_cell_may_collapse = true;
        small = whole;
        tried = trials.grains(trial_of(given, continuum, whole), continuum.settle_of_trial, true);
    }
    const Grains& grains = *tried;
    const bool small_enough = flat && flat_width_error <= share_of_cell * error;
    const FlatBox chosen = small_enough ? small : whole;
    plan.particles = chosen.number;
    plan.box_x = chosen.x;
    plan.box_y = chosen.y;
    plan.cell = chosen.number < whole.number ? flat_width_error : 0.0;
    const double share = static_cast<double>(grains.particles) / static_cast<double>(chosen.number);

    const Spread found = spread(grains.heights, static_cast<std::size_t>(grains.settled));
    const double one_cycle = found.value * std::sqrt(share);
    const double wanted = std::pow(one_cycle / (share_of_statistics * error), 2);
    const auto threads = static_cast<double>(std::max(1U, std::thread::hardware_concurrency()));
    const double worth = std::floor(wanted * share_of_settling / static_cast<double>(plan.settle));
    plan.seeds = static_cast<std::int64_t>(std::clamp(worth, 1.0, threads));
    const double each = wanted / static_cast<double>(plan.seeds * block_cycles);
    plan.average = block_cycles * static_cast<std::int64_t>(std::max(1.0, std::ceil(each)));
    plan.statistics = one_cycle / std::sqrt(static_cast<double>(plan.average * plan.seeds));
    plan.uncertainty = found.uncertainty;
    plan.drift = drift(grains.heights, static_cast<std::size_t>(plan.settle), static_cast<std::size_t>(plan.average),
                       found.value);
    plan.start = continuum.start * static_cast<double>(std::min(continuum.average, plan.average)) /
                 static_cast<double>(plan.average);
    plan.seconds = static_cast<double>(plan.seeds) * (trials.start_of_program() + grains.seconds_once +
                                                      seconds_of(grains, plan.settle + plan.average) / share);
    const double bins = continuum.lid / given.sample.bin;
    plan.bytes = grains.bytes_per_particle * static_cast<double>(plan.particles) +
                 bytes_a_bin * bins * static_cast<double>(given.sample.phases);
    return plan;
}

}  // namespace shaken::plan
