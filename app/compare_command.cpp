// SPDX-License-Identifier: MIT
#include "app/compare_command.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <numeric>

#include "app/child_process.hpp"
#include "app/exit_codes.hpp"
#include "compare/compare_file.hpp"
#include "compare/medium.hpp"
#include "compare/summary.hpp"
#include "files/atomic_write.hpp"
#include "files/errors.hpp"
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

compare::Cost md_cost(const files::Hdf5File& file, const scene::Scene& scene) {
    compare::Cost cost = cost_of(file);
    std::vector<double> cycles = per_cycle(file.read<double>("/observables/pair_collisions/value"), scene);
    const auto n = static_cast<double>(cycles.size());
    for (double& collisions : cycles) collisions /= static_cast<double>(scene.number_of_particles);
    const double mean = std::accumulate(cycles.begin(), cycles.end(), 0.0) / n;
    double spread = 0.0;
    for (const double collisions : cycles) spread += (collisions - mean) * (collisions - mean);
    cost.collisions_per_particle_per_cycle = mean;
    if (cycles.size() > 1) cost.collisions_per_particle_per_cycle_error = std::sqrt(spread / (n * (n - 1.0)));
    return cost;
}

compare::Cost continuum_cost(const files::Hdf5File& file, const scene::Scene& scene) {
    compare::Cost cost = cost_of(file);
    const std::vector<double> cycles = per_cycle(file.read<double>("/observables/steps/value"), scene);
    cost.steps_per_cycle = std::accumulate(cycles.begin(), cycles.end(), 0.0) / static_cast<double>(cycles.size());
    return cost;
}

void print_number(const nlohmann::ordered_json& of, const std::string& name, const std::string& key) {
    const auto text = [](const nlohmann::ordered_json& value) {
        return value.is_number() ? fmt::format("{:.4g}", value.get<double>()) : std::string("-");
    };
    const auto error = of.find(key + "_error");
    fmt::print("  {:<44} {:>9}{}\n", name, text(of.at(key)),
               error != of.end() && error->is_number() ? fmt::format(" +- {:.2g}", error->get<double>()) : "");
}

void print_summary(const nlohmann::ordered_json& summary) {
    for (const char* engine : {"md", "continuum"}) {
        const auto& numbers = summary.at(engine);
        fmt::print("{}\n", engine);
        print_number(numbers.at("shock"), "shock forms at ft", "formation_phase");
        print_number(numbers.at("shock"), "shock leaves the layer at ft", "leaving_phase");
        print_number(numbers.at("shock"), "mean shock speed, sqrt(g sigma)", "mean_speed");
        print_number(numbers, "largest Mach number", "max_mach");
        print_number(numbers, "shock width over mean free path, ft = 0.22", "width_over_mean_free_path");
        print_number(numbers, "CPU seconds", "cpu_seconds");
    }
    fmt::print("both\n");
    print_number(summary, "z_cm rms difference, percent", "zcm_rms_percent");
    print_number(summary, "  with the floor half a diameter up", "zcm_rms_percent_half_diameter");
    print_number(summary, "shock location rms difference, sigma", "shock_location_rms");
}

}  // namespace

int run_compare(const std::filesystem::path& folder) {
    const files::Hdf5File md_file = open_output(folder, "md"), continuum_file = open_output(folder, "continuum");
    const std::string text = md_file.read_text("/provenance/scene");
    if (continuum_file.read_text("/provenance/scene") != text) {
        throw files::Damaged(fmt::format("{}: md.h5 and continuum.h5 are of different scenes", folder.string()));
    }
    const scene::Scene scene = scene::parse_scene(text, (folder / "md.h5").string() + " (scene)");
    const compare::Medium medium = compare::medium_of(scene);
    const auto md = compare::measure(fields::PhaseMoments::read(md_file, "/profiles"), scene.motion, medium);
    const auto continuum =
        compare::measure(fields::PhaseMoments::read(continuum_file, "/profiles"), scene.motion, medium);
    const std::filesystem::path aside = folder / "compare.h5.part";
    compare::write_compare_file(aside, md, continuum, medium, {text, scene.md.seed, ""});
    std::filesystem::rename(aside, folder / "compare.h5");
    const auto summary =
        compare::summarise(md, continuum, scene, md_cost(md_file, scene), continuum_cost(continuum_file, scene));
    files::write_atomically(folder / "summary.json", summary.dump(2) + "\n");
    print_summary(summary);
    return exit_code::done;
}

int run_report(const std::filesystem::path& folder) {
    for (const char* name : {"compare.h5", "summary.json", "md.h5"}) {
        if (!std::filesystem::exists(folder / name)) {
            throw files::NoInput(fmt::format("{}: no such file; make it with: shaken compare {}",
                                             (folder / name).string(), folder.string()));
        }
    }
    spdlog::info("drawing the figures and the report");
    const std::filesystem::path script = share_folder() / "scripts" / "figures" / "report.py";
    if (ChildProcess(drawing_python(), {script.string(), folder.string()}).wait() != 0) {
        throw std::runtime_error(fmt::format("{}: drawing the report failed", folder.string()));
    }
    return exit_code::done;
}

}  // namespace shaken::app
