// SPDX-License-Identifier: MIT
#include "app/patterns_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/exit_codes.hpp"
#include "app/options.hpp"
#include "compare/patterns/pattern_summary.hpp"
#include "files/atomic_write.hpp"
#include "files/errors.hpp"
#include "files/hdf5.hpp"
#include "run/resume.hpp"
#include "compare/scenes.hpp"
#include "scene/read_scene.hpp"

namespace shaken::app {

namespace {

constexpr const char* group = "/height_maps";

compare::PatternSummary pattern_of(const files::Hdf5File& file, const std::filesystem::path& path,
                                   const PatternsOptions& options) {
    const scene::Scene scene = compare::parse_scene(file.read_text("/provenance/scene"), path.string() + " (scene)");
    const fields::HeightMaps maps = fields::HeightMaps::read(file, group);
    compare::PatternWindow window;
    window.phase = options.phase;
    window.first = options.first.value_or(scene.sample.settle);
    window.cycles = options.cycles.value_or(scene.sample.settle + scene.sample.average - window.first);
    if (maps.rows_at(window.phase, 0).empty())
        throw UsageError(fmt::format("--phase {}: {} has maps at the multiples of {:.6g}", window.phase, path.string(),
                                     1.0 / static_cast<double>(scene.sample.maps)));
    const auto rows = maps.rows_at(window.phase, window.first);
    if (rows.empty() || maps.cycle(rows.front()) >= window.first + window.cycles)
        throw UsageError(fmt::format("no map in cycles {} to {}; {} has cycles {} to {}", window.first,
                                     window.first + window.cycles - 1, path.string(), maps.cycle(0),
                                     maps.cycle(maps.rows() - 1)));
    // A run that was stopped has fewer than its scene asks for, and is said to.
    window.cycles = std::min(window.cycles, maps.cycle(maps.rows() - 1) + 1 - window.first);
    return compare::summarise_pattern(maps, window, options.waves);
}

void print_measure(const char* name, const compare::Measure& measure, const char* unit) {
    fmt::print("  {:<34} {:>10.4g} +- {:.2g} {}\n", name, measure.value, measure.error, unit);
}

void print_pattern(const std::string& engine, const compare::PatternSummary& s) {
    fmt::print("{}: {} maps at ft = {}, cycles {} to {}\n", engine, s.maps, s.window.phase, s.window.first,
               s.window.first + s.window.cycles - 1);
    print_measure("<psi^2>", s.mean_square, "sigma^2");
    print_measure("order P_max", s.order, "");
    print_measure("the same, interpolated as published", s.interpolated_order, "");
    fmt::print("  {:<34} {:>10.4g} sigma\n", "dominant wavelength", s.wavelength);
    fmt::print("  {:<34} {:>10.4g} degrees\n", "angle of its wavevector", 180.0 / std::numbers::pi * s.angle);
    fmt::print("  {:<34} {:>10.4g}\n", "share of <psi^2> at half frequency", s.coherent_share);
    fmt::print("  waves of the box    rms, sigma   at half frequency, sigma   factor a cycle\n");
    for (const auto& w : s.waves) {
        fmt::print("  {:>8} {:>8}   {:>10.3g}   {:>12.3g} +- {:<8.2g}   {:>12.4g}\n", w.wave.mx, w.wave.my,
                   w.root_mean_square, w.coherent, w.coherent_error, w.multiplier);
    }
    if (s.fluctuations.empty()) return;
    fmt::print("  wavelength, sigma   <psi^2> of it   that lasts   that alternates         its factor a cycle\n");
    for (const auto& f : s.fluctuations) {
        fmt::print("  {:>17.4g}   {:>13.3g}   {:>10.3g}   {:>10.3g} +- {:<8.2g}   {}\n", f.wavelength, f.power,
                   f.decays.persistent, f.decays.alternating, f.errors.alternating,
                   compare::tells_its_factor(f)
                       ? fmt::format("{:>9.3f} +- {:<.2g}", f.decays.alternating_factor, f.errors.alternating_factor)
                       : fmt::format("{:>9}", "-"));
    }
}

}  // namespace

int run_patterns(const PatternsOptions& options) {
    run::restore_outputs(options.folder);
    nlohmann::ordered_json all;
    for (const std::string engine : {"md", "continuum"}) {
        const std::filesystem::path path = options.folder / (engine + ".h5");
        if (!std::filesystem::exists(path)) continue;
        const files::Hdf5File file(path, files::Open::read);
        if (!file.has(group)) continue;
        const compare::PatternSummary summary = pattern_of(file, path, options);
        all[engine] = compare::to_json(summary);
        if (!options.json) print_pattern(engine, summary);
    }
    if (all.empty())
        throw files::NoInput(fmt::format("{}: no md.h5 or continuum.h5 with maps; run with --set sample.map_bin=2",
                                         options.folder.string()));
    files::write_atomically(options.folder / "patterns.json", all.dump(2) + "\n");
    if (options.json) fmt::print("{}\n", all.dump());
    return exit_code::done;
}

}  // namespace shaken::app
