// SPDX-License-Identifier: MIT
#include "app/plan_command.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/exit_codes.hpp"
#include "app/options.hpp"
#include "compare/scenes.hpp"
#include "continuum/resolve.hpp"
#include "files/atomic_write.hpp"
#include "files/errors.hpp"
#include "plan/proposal.hpp"
#include "scene/read_scene.hpp"

namespace shaken::app {

namespace {

using plan::per_cent;
using plan::Proposal;

std::string written_bytes(double bytes) {
    return bytes < 1e6 ? fmt::format("{:.0f} kB", 1e-3 * bytes) : fmt::format("{:.3g} MB", 1e-6 * bytes);
}

std::string wish_of(const Proposal& p) {
    return p.wish.error ? fmt::format("an error of {}", per_cent(*p.wish.error))
                        : fmt::format("{:g} s of processor time", *p.wish.seconds);
}

std::string commands_of(const Proposal& p, const std::filesystem::path& scene) {
    const std::string md =
        p.md.seeds == 1
            ? fmt::format("shaken md {} --out out/md", scene.string())
            : fmt::format("scripts/sweep {} --engine md --vary md.seed=1:{} --out out/md", scene.string(), p.md.seeds);
    return fmt::format("{}\nshaken continuum {} --set sample.average={} --out out/continuum\n", md, scene.string(),
                       p.continuum.average);
}

std::string text_of(const Proposal& p) {
    const auto& c = p.continuum;
    const auto& m = p.md;
    std::string text =
        fmt::format("for {}, from trials of {:.1f} s of processor time\n\n", wish_of(p), p.trial_seconds);
    const auto line = [&](const char* what, const std::string& continuum, const std::string& md) {
        text += fmt::format("{:<9} {:<34} {}\n", what, continuum, md);
    };
    line("", "continuum", "MD");
    line("computes", fmt::format("{}D, {}, spacing {:g}, lid {:g}", c.dimension, c.scheme, c.spacing, c.lid),
         fmt::format("{} particles on {:.4g} x {:.4g}", m.particles, m.box_x, m.box_y));
    line("cycles", fmt::format("{} to settle, {} averaged", c.settle, c.average),
         fmt::format("{} to settle, {} averaged, {} seed{}", m.settle, m.average, m.seeds, m.seeds == 1 ? "" : "s"));
    line("time", fmt::format("{:.3g} s", c.seconds), fmt::format("{:.3g} s", m.seconds));
    line("memory", written_bytes(c.bytes), written_bytes(m.bytes));
    line("error", per_cent(c.error()), fmt::format("{}", per_cent(m.error())));
    line("", fmt::format("grid and step {}, lid {}", per_cent(c.grid), per_cent(c.lid_error)),
         fmt::format("statistics {}, known to {:.0f} %", per_cent(m.statistics), 100.0 * m.uncertainty));
    line("", fmt::format("start {}, scatter {}", per_cent(c.start), per_cent(c.scatter)),
         fmt::format("start {}, cell {}, drift {}", per_cent(m.start), per_cent(m.cell), per_cent(m.drift)));
    if (c.dimension > 1) line("", fmt::format("columns {}", per_cent(c.columns)), "");
    text +=
        "\nErrors are of z_cm(ft), rms over twenty phases; how far the equations are from the grains is another "
        "matter.\n\n";
    for (const auto& reason : p.reasons)
        text += fmt::format("{:<18} {:<16} {}\n", reason.key, reason.value, reason.words);
    return text;
}

nlohmann::ordered_json json_of(const Proposal& p, const std::filesystem::path& scene) {
    const auto& c = p.continuum;
    const auto& m = p.md;
    nlohmann::ordered_json reasons = nlohmann::ordered_json::array();
    for (const auto& r : p.reasons) reasons.push_back({{"key", r.key}, {"value", r.value}, {"why", r.words}});
    return {{"scene", scene.string()},
            {"aimed_error", p.aimed},
            {"trial_seconds", p.trial_seconds},
            {"continuum",
             {{"dimension", c.dimension},
              {"scheme", c.scheme},
              {"spacing", c.spacing},
              {"spacing_horizontal", c.spacing_horizontal},
              {"lid", c.lid},
              {"settle", c.settle},
              {"average", c.average},
              {"seconds", c.seconds},
              {"bytes", c.bytes},
              {"error", c.error()},
              {"error_grid", c.grid},
              {"error_columns", c.columns},
              {"error_lid", c.lid_error},
              {"error_start", c.start},
              {"error_scatter", c.scatter}}},
            {"md",
             {{"particles", m.particles},
              {"box_x", m.box_x},
              {"box_y", m.box_y},
              {"settle", m.settle},
              {"average", m.average},
              {"seeds", m.seeds},
              {"seconds", m.seconds},
              {"bytes", m.bytes},
              {"error", m.error()},
              {"error_statistics", m.statistics},
              {"error_statistics_uncertainty", m.uncertainty},
              {"error_start", m.start},
              {"error_cell", m.cell},
              {"error_drift", m.drift}}},
            {"settings", p.settings},
            {"reasons", reasons}};
}

/// Every line of the text a comment, above the scene.
std::string commented(const std::string& text) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        result += end == at ? "#\n" : fmt::format("# {}\n", text.substr(at, end - at));
        at = end + 1;
    }
    return result;
}

}  // namespace

int run_plan(const PlanOptions& options) {
    try {
        plan::Wish wish{std::nullopt, options.seconds};
        if (options.error) wish.error = plan::share_of(*options.error);
        std::vector<std::string> settings = options.overrides;
        const scene::Scene scene = compare::read_scene(options.scene_file, settings);
        const std::filesystem::path out = options.out.empty()
                                              ? std::filesystem::path(options.scene_file.stem().string() + ".plan.toml")
                                              : options.out;
        if (std::filesystem::exists(out) && !options.overwrite)
            throw files::CannotCreate(
                fmt::format("{}: is there already; name another with --out, or replace it with "
                            "--overwrite",
                            out.string()));
        const Proposal p = plan::propose(scene, wish);
        settings.insert(settings.end(), p.settings.begin(), p.settings.end());
        const scene::Scene planned = continuum::resolve(compare::read_scene(options.scene_file, settings));
        const std::string commands = commands_of(p, out);
        files::write_atomically(
            out, commented(fmt::format("{}\n{}", text_of(p), commands)) + "\n" + scene::print_scene(planned));
        if (options.json)
            fmt::print("{}\n", json_of(p, out).dump());
        else
            fmt::print("{}\nwritten to {}; run it with\n{}", text_of(p), out.string(), commands);
    } catch (const plan::CannotPlan& error) {
        throw UsageError(error.what());
    }
    return exit_code::done;
}

}  // namespace shaken::app
