// SPDX-License-Identifier: MIT
#include "plan/trials.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <numeric>
#include <span>
#include <utility>

#include "continuum/errors.hpp"
#include "continuum/solver.hpp"
#include "files/checkpoint_file.hpp"
#include "files/hdf5.hpp"
#include "md/errors.hpp"
#include "run/continuum_layer.hpp"
#include "run/driver.hpp"
#include "run/md_layer.hpp"

namespace shaken::plan {

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

namespace {

constexpr std::int64_t most_md_cycles = 96, least_md_cycles = 16;
constexpr std::int64_t patch_columns = 8;
constexpr double patch_seconds = 0.5;
constexpr std::size_t lid_cycles = 48;

scene::Scene sampled_from_start(scene::Scene scene, std::int64_t cycles) {
    scene.sample.settle = 0;
    scene.sample.average = cycles;
    scene.sample.frames = 0;
    scene.sample.map_bin = 0.0;
    return scene;
}

/// Takes heights of the centre of mass out of what a run lets go of, every cycle at twenty phases.
class HeightsOfRun {
  public:
    explicit HeightsOfRun(std::int64_t phases_sampled) : step_(static_cast<std::size_t>(phases_sampled) / phases) {}
    run::Emit emit() {
        return [this](run::Stream kind, std::span<const double> record) {
            if (kind != run::Stream::height) return;
            const auto cycle = static_cast<std::size_t>(record[0]), index = static_cast<std::size_t>(record[1]);
            if (index % step_ != 0) return;
            heights_.resize(cycle + 1);
            heights_[cycle][index / step_] = record[2];
        };
    }
    Heights take(std::int64_t cycles) {
        heights_.resize(static_cast<std::size_t>(cycles));
        return std::move(heights_);
    }

  private:
    std::size_t step_;
    Heights heights_;
};

const run::AskedToStop never = [] { return false; };
const run::Emit to_nobody = [](run::Stream, std::span<const double>) {};

/// Writes what a run of so many averages leaves, a checkpoint at its start and one at its end, and throws it away.
template <class Engine, class Record>
double seconds_to_leave(const Engine& engine, const Record& record) {
    const double begin = cpu_seconds();
    const std::filesystem::path aside =
        std::filesystem::temp_directory_path() / ("shaken_plan_" + std::to_string(::getpid()));
    for (int written = 0; written < 2; ++written) {
        files::CheckpointFile checkpoint(aside);
        engine.save(checkpoint);
        record.save(checkpoint);
        checkpoint.commit();
    }
    {
        files::Hdf5File averages(aside.string() + ".h5", files::Open::create);
        record.sampler().moments().write(averages, "/profiles");
        averages.close();
    }
    std::filesystem::remove(aside);
    std::filesystem::remove(aside.string() + ".h5");
    return cpu_seconds() - begin;
}

scene::Scene one_column(const scene::Scene& given, const std::string& scheme, double spacing, double lid,
                        std::size_t cycles) {
    scene::Scene scene = sampled_from_start(given, static_cast<std::int64_t>(cycles));
    scene.continuum.dimension.name = "1";
    scene.continuum.scheme.name = scheme;
    scene.continuum.spacing = spacing;
    scene.continuum.lid = lid;
    scene.initial.noise = scene.initial.wave = 0.0;
    return scene;
}

Column run_column(const scene::Scene& scene) {
    const double first = cpu_seconds();
    run::ContinuumLayer layer(scene);
    const double seconds_to_begin = cpu_seconds() - first;
    // What is left grows with the cycles averaged over, of which a plan's continuum has two as a rule.
    scene::Scene end = scene;
    end.sample.settle = std::max<std::int64_t>(0, scene.sample.average - 2);
    end.sample.average = 2;
    run::ContinuumLayerRecord record_of_end(continuum::resolve(end));
    const scene::Schedule schedule(end);
    HeightsOfRun heights(scene.sample.phases);
    const double begin = cpu_seconds();
    run::lead(layer, never, heights.emit(), [&] {
        const scene::Instant at = schedule.instant(layer.next_sample() - 1);
        if (schedule.is_averaged(at.cycle)) record_of_end.sample(layer.state(), at, to_nobody);
        return true;
    });
    if (!std::isfinite(layer.state().mass() + layer.state().ledger().energy))
        throw continuum::RunFailed("continuum: a trial is not finite", 0.0);
    const auto cycles = static_cast<double>(scene.sample.average);
    return {heights.take(scene.sample.average), (cpu_seconds() - begin) / cycles,
            static_cast<double>(layer.state().steps()) / cycles, seconds_to_begin,
            seconds_to_leave(layer.state(), record_of_end)};
}

/// settle cycles, then as many as the budget allows.
Grains run_grains(const scene::Scene& planned, std::int64_t settle, double budget) {
    const scene::Scene scene = sampled_from_start(planned, settle + most_md_cycles);
    Grains grains;
    const double start = cpu_seconds();
    run::MdLayer layer(scene);
    grains.seconds_once = cpu_seconds() - start;
    // Fills each of its ten blocks, as a run does: empty ones would be written in no time.
    run::MdLayerRecord record_of_run(sampled_from_start(planned, least_md_cycles));
    HeightsOfRun heights(scene.sample.phases);
    double seconds = 0.0, begin = cpu_seconds();
    run::lead(layer, never, heights.emit(), [&] {
        seconds += cpu_seconds() - begin;
        const std::int64_t sampled = layer.next_sample(), cycles = sampled / scene.sample.phases;
        record_of_run.sample(layer.state(), scene::Schedule(scene).instant(sampled - 1), to_nobody);
        const bool is_whole = sampled % scene.sample.phases == 0;
        if (is_whole) grains.seconds.push_back(std::exchange(seconds, 0.0));
        const bool is_enough = is_whole && cycles >= settle + least_md_cycles && cpu_seconds() - start > budget;
        begin = cpu_seconds();
        return !is_enough;
    });
    const auto cycles = static_cast<std::int64_t>(grains.seconds.size());
    grains.heights = heights.take(cycles);
    grains.settled = settle;
    const md::Simulation& simulation = layer.state();
    grains.seconds_once += seconds_to_leave(simulation, record_of_run);
    grains.particles = simulation.particles();
    const auto number = static_cast<double>(grains.particles);
    grains.bytes_per_particle = static_cast<double>(simulation.memory()) / number;
    grains.ceiling_contacts =
        static_cast<double>(simulation.counters().ceiling_collisions) / number / static_cast<double>(cycles);
    return grains;
}

}  // namespace

const Column* Trials::column(const std::string& scheme, double spacing, double lid, std::size_t cycles, bool needed) {
    const auto key = std::make_tuple(scheme, spacing, lid);
    const auto found = columns_.find(key);
    if (found != columns_.end() && (!found->second || found->second->heights.size() >= cycles))
        return found->second ? &*found->second : nullptr;
    // From the nearest coarser one: cells and steps both grow with 1/spacing.
    double expected = 0.0;
    for (const auto& [other, column] : columns_) {
        const auto& [name, coarser, height] = other;
        if (name != scheme || !column || coarser < spacing || expected > 0.0) continue;
        expected =
            column->seconds_per_cycle * std::pow(coarser / spacing, 2) * (lid / height) * static_cast<double>(cycles);
    }
    if (!needed && spent_columns_ + expected > budget_) return nullptr;
    const double begin = cpu_seconds();
    std::optional<Column> column;
    try {
        column = run_column(one_column(scene_, scheme, spacing, lid, cycles));
    } catch (const continuum::RunFailed&) {
        column.reset();
    }
    if (!needed) spent_columns_ += cpu_seconds() - begin;
    auto& kept = columns_[key] = std::move(column);
    return kept ? &*kept : nullptr;
}

const Heights* Trials::under_lid(const std::string& scheme, double spacing, double lid) {
    const auto key = std::make_tuple(scheme, spacing, lid);
    const auto found = lids_.find(key);
    if (found != lids_.end()) return found->second ? &*found->second : nullptr;
    scene::Scene scene = one_column(scene_, scheme, spacing, lid, lid_cycles);
    scene.sample.phases = static_cast<std::int64_t>(phases);
    std::optional<Heights> heights;
    try {
        heights = run_column(scene).heights;
    } catch (const continuum::RunFailed&) {
        heights.reset();
    }
    auto& kept = lids_[key] = std::move(heights);
    return kept ? &*kept : nullptr;
}

double seconds_of(const Grains& grains, std::int64_t cycles) {
    const auto known = static_cast<std::int64_t>(grains.seconds.size());
    const auto begin = grains.seconds.begin();
    const double first = std::accumulate(begin, begin + std::min(cycles, known), 0.0);
    const double late =
        std::accumulate(begin + known / 2, grains.seconds.end(), 0.0) / static_cast<double>(known - known / 2);
    return first + late * static_cast<double>(std::max<std::int64_t>(0, cycles - known));
}

const Grains* Trials::grains(const scene::Scene& planned, std::int64_t settle, bool needed) {
    const auto [place, is_new] = grains_.try_emplace(planned.number_of_particles);
    std::optional<Grains>& kept = place->second;
    if (is_new || (needed && !kept)) try {
            kept = run_grains(planned, settle, budget_);
        } catch (const md::Stalled&) {
            if (needed) throw;
        }
    return kept ? &*kept : nullptr;
}

double Trials::seconds_per_update(const scene::Scene& planned) {
    const int dimension = planned.continuum.dimension.name == "2" ? 2 : 3;
    const auto known = updates_.find(dimension);
    if (known != updates_.end()) return known->second;
    scene::Scene scene = sampled_from_start(planned, 1);
    const double widest = static_cast<double>(patch_columns) * scene.continuum.spacing_horizontal;
    const double area = scene.box.x * scene.box.y;
    scene.box.x = std::min(scene.box.x, widest);
    scene.box.y = std::min(scene.box.y, widest);
    scene.number_of_particles = std::max<std::int64_t>(
        1, std::llround(static_cast<double>(scene.number_of_particles) * scene.box.x * scene.box.y / area));
    continuum::Solver solver(scene);
    const double start = cpu_seconds();
    for (std::int64_t phase = 1; phase < scene.sample.phases && cpu_seconds() - start < patch_seconds; ++phase)
        solver.advance_to_instant(0, phase);
    const auto cells = static_cast<double>(solver.cells_x() * solver.cells_y() * solver.cells_z());
    const double seconds = (cpu_seconds() - start) / (cells * static_cast<double>(solver.steps()));
    return updates_[dimension] = seconds;
}

}  // namespace shaken::plan
