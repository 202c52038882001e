// SPDX-License-Identifier: MIT
#include "app/compare_command.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "app/child_process.hpp"
#include "app/exit_codes.hpp"
#include "app/signals.hpp"
#include "app/start_keys.hpp"
#include "compare/compare_file.hpp"
#include "compare/independence.hpp"
#include "compare/layout.hpp"
#include "compare/medium.hpp"
#include "compare/scenes.hpp"
#include "compare/summary.hpp"
#include "compare/validity.hpp"
#include "fields/height_maps.hpp"
#include "fields/memory.hpp"
#include "fields/period.hpp"
#include "files/atomic_write.hpp"
#include "files/errors.hpp"
#include "run/notes.hpp"
#include "run/resume.hpp"
#include "scene/read_scene.hpp"

namespace shaken::app {

namespace {

files::Hdf5File open_output(const std::filesystem::path& folder, const std::string& engine) {
    const std::filesystem::path path = folder / (engine + ".h5");
    if (!std::filesystem::exists(path)) {
        throw files::NoInput(
            fmt::format("{}: no such file; make it with: shaken {} SCENE --out DIR", path.string(), engine));
    }
    return {path, files::Open::read};
}

/// Differences over each averaged cycle of a count that only grows; the last one is short by one sample and left out
/// unless it is the only one.
std::vector<double> per_cycle(const std::vector<double>& count, const scene::Scene& scene) {
    const auto phases = static_cast<std::size_t>(scene.sample.phases);
    std::vector<double> differences;
    for (auto first = static_cast<std::size_t>(scene.sample.settle) * phases; first + phases < count.size();
         first += phases) {
        differences.push_back(count[first + phases] - count[first]);
    }
    if (differences.empty()) differences.push_back(count.back() - count[count.size() - phases]);
    return differences;
}

compare::Cost cost_of(const files::Hdf5File& file) {
    compare::Cost cost;
    cost.wall_seconds = file.read_number_attribute("/run", "wall_seconds");
    cost.cpu_seconds = file.read_number_attribute("/run", "cpu_seconds");
    return cost;
}

/// What several runs of one layer took: sums of time, means over all their cycles.
class CostOfRuns {
  public:
    void add(const files::Hdf5File& file, const scene::Scene& scene) {
        const compare::Cost own = cost_of(file);
        const auto sum = [](std::optional<double>& total, std::optional<double> part) {
            if (part) total = total.value_or(0.0) + *part;
        };
        sum(cost_.wall_seconds, own.wall_seconds);
        sum(cost_.cpu_seconds, own.cpu_seconds);
        for (const double count : per_cycle(file.read<double>("/observables/pair_collisions/value"), scene))
            collisions_.push_back(count / static_cast<double>(scene.number_of_particles));
    }
    compare::Cost mean() const {
        compare::Cost cost = cost_;
        const fields::MeanWithMemory collisions = fields::mean_with_memory(collisions_);
        cost.collisions_per_particle_per_cycle = collisions.mean;
        if (std::isfinite(collisions.error)) cost.collisions_per_particle_per_cycle_error = collisions.error;
        return cost;
    }

  private:
    compare::Cost cost_;
    std::vector<double> collisions_;  // per particle, one entry a cycle
};

compare::Cost continuum_cost(const files::Hdf5File& file, const scene::Scene& scene) {
    compare::Cost cost = cost_of(file);
    const std::vector<double> cycles = per_cycle(file.read<double>("/observables/steps/value"), scene);
    cost.steps_per_cycle = std::accumulate(cycles.begin(), cycles.end(), 0.0) / static_cast<double>(cycles.size());
    return cost;
}

/// Empty for a file of an earlier version; so are its notes.
nlohmann::ordered_json validity_of(const files::Hdf5File& file) {
    nlohmann::ordered_json numbers = nlohmann::ordered_json::object();
    for (const auto& [name, none] : compare::named({}))
        if (file.has("/validity/" + name)) numbers[name] = file.read_number("/validity/" + name);
    if (numbers.empty()) return numbers;
    numbers["knudsen_limit"] = compare::knudsen_limit;
    numbers["omega_tau_limit"] = compare::omega_tau_limit;
    numbers["packed_share_limit"] = compare::packed_share_limit;
    return numbers;
}

run::Notes notes_of(const files::Hdf5File& file) {
    return file.has("/run/notes") ? run::parted(file.read_text("/run/notes")) : run::Notes{};
}

scene::Scene scene_of(const files::Hdf5File& file, const std::filesystem::path& path) {
    return compare::parse_scene(file.read_text("/provenance/scene"), path.string() + " (scene)");
}

/// The averages of a run as far as it has got. Throws files::NoInput before its first averaged cycle is whole.
fields::PhaseMoments reached_moments(const files::Hdf5File& file, const std::string& path) {
    const std::optional<fields::PhaseMoments> reached = fields::PhaseMoments::read(file, "/profiles").reached();
    if (!reached)
        throw files::NoInput(fmt::format("{}: the run has not come to the end of its first averaged cycle", path));
    return *reached;
}

/// What is said of an average over fewer cycles than the scene asks for.
std::optional<std::string> note_of_part(const std::string& engine, const fields::PhaseMoments& moments,
                                        const scene::Scene& scene) {
    if (moments.cycles() == scene.sample.average) return std::nullopt;
    return fmt::format("{} was stopped on its way: averages are over {} of {} cycles.", engine, moments.cycles(),
                       scene.sample.average);
}

/// The averages of a run, the higher of two cycles first, and what is found of its period beside that of the runs
/// before. A single cycle has no period to ask for.
fields::PhaseMoments moments_of(const files::Hdf5File& file, const std::string& path, bool first_cycle,
                                const scene::Scene& scene, compare::Periods& found) {
    fields::PhaseMoments moments =
        first_cycle ? fields::PhaseMoments::read(file, "/profiles") : reached_moments(file, path);
    if (first_cycle) {
        found.of_runs.emplace_back();
        return moments.first_cycle();
    }
    found.of_runs.push_back(fields::period_of(moments.centre_of_mass(), moments.phases()));
    found.keeps_flows_apart = found.keeps_flows_apart && moments.keeps_flows_apart();
    if (file.has("/height_maps"))
        found.opposite_share =
            std::max(found.opposite_share,
                     fields::opposite_share(fields::HeightMaps::read(file, "/height_maps"), scene.sample.settle));
    if (fields::odd_cycles_are_higher(moments.centre_of_mass(), moments.phases())) moments.exchange_flows();
    return moments;
}

/// Each once, whatever the number of runs it holds for.
run::Notes notes_of_starts(const std::vector<compare::AveragedRun>& runs) {
    run::Notes notes;
    for (const compare::AveragedRun& run : runs)
        for (const std::string& note : notes_of_start(run.scene))
            if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
    return notes;
}

void add_period(nlohmann::ordered_json& engine, const std::string& name, const compare::Periods& found,
                const compare::Layout& layout) {
    if (found.opposite_share > 0.0) engine["opposite_share"] = found.opposite_share;
    for (const std::string& note : compare::notes_of_period(name, found, layout)) engine["notes"].push_back(note);
}

void print_number(const nlohmann::ordered_json& of, const std::string& name, const std::string& key) {
    const auto text = [](const nlohmann::ordered_json& value) {
        return value.is_number() ? fmt::format("{:.4g}", value.get<double>()) : std::string("-");
    };
    const auto error = of.find(key + "_error");
    fmt::print("  {:<44} {:>9}{}\n", name, text(of.at(key)),
               error != of.end() && error->is_number() ? fmt::format(" +- {:.2g}", error->get<double>()) : "");
}

void print_shock(const nlohmann::ordered_json& shock) {
    print_number(shock, "shock forms at ft", "formation_phase");
    print_number(shock, "shock leaves the layer at ft", "leaving_phase");
    print_number(shock, "mean shock speed, sqrt(g sigma)", "mean_speed");
}

void print_summary(const nlohmann::ordered_json& summary) {
    for (const char* engine : {"md", "continuum"}) {
        const auto& numbers = summary.at(engine);
        const auto& period = numbers.at("period");
        fmt::print("{}\n  period: {}\n", engine,
                   compare::in_words(period.is_null() ? std::nullopt : std::optional(period.get<int>())));
        print_shock(numbers.at("shock"));
        if (numbers.contains("second_cycle")) {
            fmt::print("  in the second cycle\n");
            print_shock(numbers.at("second_cycle").at("shock"));
        }
        print_number(numbers, "largest Mach number", "max_mach");
        print_number(numbers, "shock width over mean free path, ft = 0.22", "width_over_mean_free_path");
        print_number(numbers, "CPU seconds", "cpu_seconds");
    }
    fmt::print("both\n");
    print_number(summary, "z_cm rms difference, percent", "zcm_rms_percent");
    print_number(summary, "  with the floor half a diameter up", "zcm_rms_percent_half_diameter");
    print_number(summary, "shock location rms difference, sigma", "shock_location_rms");
    const auto& validity = summary.at("continuum").at("validity");
    for (const auto& [name, words] :
         {std::pair{"knudsen", "Knudsen number, mean over the layer"}, std::pair{"knudsen_largest", "  largest"},
          std::pair{"omega_tau", "omega tau, mean over the layer"}, std::pair{"omega_tau_largest", "  largest"},
          std::pair{"packed_share", "share of mass above nu = 0.6"}, std::pair{"packed_share_largest", "  largest"}})
        if (validity.contains(name)) print_number(validity, words, name);
    for (const char* engine : {"md", "continuum"})
        for (const auto& note : summary.at(engine).at("notes")) fmt::print("note: {}\n", note.get<std::string>());
}

}  // namespace

int run_compare(const CompareOptions& options) {
    const std::filesystem::path& folder = options.folder;
    const std::vector<std::filesystem::path> md_folders =
        options.md.empty() ? std::vector<std::filesystem::path>{folder} : options.md;
    const std::filesystem::path continuum_folder = options.continuum.empty() ? folder : options.continuum;
    for (const std::filesystem::path& md_folder : md_folders) run::restore_outputs(md_folder);
    run::restore_outputs(continuum_folder);
    const files::Hdf5File continuum_file = open_output(continuum_folder, "continuum");
    const scene::Scene scene = scene_of(continuum_file, continuum_folder / "continuum.h5");
    std::optional<fields::PhaseMoments> md_moments;
    std::vector<compare::AveragedRun> runs;
    CostOfRuns md_cost;
    compare::Periods md_periods, continuum_periods;
    run::Notes md_parts;
    for (const std::filesystem::path& md_folder : md_folders) {
        const files::Hdf5File file = open_output(md_folder, "md");
        const scene::Scene own = scene_of(file, md_folder / "md.h5");
        const compare::RecordedRun run{"md", md_folder / "md.h5", own};
        compare::refuse_other_experiment(run, {"continuum", continuum_folder / "continuum.h5", scene});
        if (!runs.empty()) compare::refuse_other_experiment({"md", runs.front().path, runs.front().scene}, run);
        try {
            const fields::PhaseMoments moments =
                moments_of(file, (md_folder / "md.h5").string(), options.first_cycle, own, md_periods);
            if (const auto note = options.first_cycle ? std::nullopt : note_of_part("An MD run", moments, own))
                md_parts.push_back(*note);
            runs.push_back({md_folder / "md.h5", own, moments.centre_of_mass()});
            if (md_moments) {
                md_moments->append(moments);
            } else {
                md_moments = moments;
            }
        } catch (const std::invalid_argument& error) {
            throw files::Damaged(fmt::format("{}: {}", (md_folder / "md.h5").string(), error.what()));
        }
        md_cost.add(file, own);
    }
    compare::refuse_dependent(runs);
    const compare::Medium medium = compare::medium_of(scene);
    const fields::PhaseMoments continuum_moments = moments_of(
        continuum_file, (continuum_folder / "continuum.h5").string(), options.first_cycle, scene, continuum_periods);
    const compare::Layouts layouts = compare::layouts_of(md_periods, continuum_periods);
    const auto md = compare::measure(*md_moments, scene.motion, medium, layouts.md);
    const auto continuum = compare::measure(continuum_moments, scene.motion, medium, layouts.continuum);
    std::filesystem::create_directories(folder);
    const std::filesystem::path aside = folder / "compare.h5.part";
    compare::write_compare_file(aside, md, continuum, medium,
                                {continuum_file.read_text("/provenance/scene"), scene.md.seed, ""});
    std::filesystem::rename(aside, folder / "compare.h5");
    auto summary = compare::summarise(md, continuum, scene, md_cost.mean(), continuum_cost(continuum_file, scene));
    summary["md"]["notes"] = notes_of_starts(runs);
    for (const std::string& note : md_parts) summary["md"]["notes"].push_back(note);
    if (const auto note = compare::note_of(md.memory, md_moments->cycles())) summary["md"]["notes"].push_back(*note);
    summary["continuum"]["validity"] = validity_of(continuum_file);
    summary["continuum"]["notes"] = notes_of(continuum_file);
    if (const auto note = options.first_cycle ? std::nullopt : note_of_part("The continuum", continuum_moments, scene))
        summary["continuum"]["notes"].push_back(*note);
    add_period(summary["md"], "The MD", md_periods, layouts.md);
    add_period(summary["continuum"], "The continuum", continuum_periods, layouts.continuum);
    for (const std::filesystem::path& md_folder : md_folders)
        summary["runs"]["md"].push_back(std::filesystem::absolute(md_folder).lexically_normal().string());
    summary["runs"]["continuum"] = std::filesystem::absolute(continuum_folder).lexically_normal().string();
    files::write_atomically(folder / "summary.json", summary.dump(2) + "\n");
    print_summary(summary);
    return exit_code::done;
}

int run_report(const std::filesystem::path& folder) {
    run::restore_outputs(folder);
    for (const char* name : {"compare.h5", "summary.json", "md.h5"}) {
        if (!std::filesystem::exists(folder / name)) {
            throw files::NoInput(fmt::format("{}: no such file; make it with: shaken compare {}",
                                             (folder / name).string(), folder.string()));
        }
    }
    spdlog::info("drawing the figures and the report");
    const std::filesystem::path script = share_folder() / "scripts" / "figures" / "report.py";
    const int drawn = ChildProcess(drawing_python(), {script.string(), folder.string()}).wait_or_stop();
    if (stop_requested()) return exit_code::stopped;
    if (drawn != 0) {
        throw std::runtime_error(fmt::format("{}: drawing the report failed", folder.string()));
    }
    return exit_code::done;
}

}  // namespace shaken::app
