// SPDX-License-Identifier: MIT
// The one command. Parses, hands on to a subcommand, and turns what was thrown into an exit code and one sentence.
#include <hdf5.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <boost/version.hpp>
#include <csignal>
#include <cstdio>

#include "app/bench_command.hpp"
#include "app/closure_command.hpp"
#include "app/compare_command.hpp"
#include "app/engine_command.hpp"
#include "app/exit_codes.hpp"
#include "app/fit_noise_command.hpp"
#include "app/patterns_command.hpp"
#include "app/plan_command.hpp"
#include "app/run_command.hpp"
#include "app/swift_hohenberg_command.hpp"
#include "compare/scenes.hpp"
#include "continuum/resolve.hpp"
#include "files/errors.hpp"
#include "md/errors.hpp"
#include "scene/errors.hpp"
#include "scene/key_reference.hpp"
#include "scene/parameters.hpp"
#include "scene/read_scene.hpp"
#include "shaken_version.hpp"

using namespace shaken;

namespace {

using namespace app;

std::string version_text() {
    return fmt::format(
        "shaken {} ({})\ncompiler   {}\nflags      {}\nlibraries  HDF5 {}.{}.{}, Boost {}.{}, fmt {}, "
        "spdlog {}.{}.{}, CLI11 {}",
        version::number, version::git_hash, version::compiler, version::compiler_flags, H5_VERS_MAJOR, H5_VERS_MINOR,
        H5_VERS_RELEASE, BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, FMT_VERSION, SPDLOG_VER_MAJOR,
        SPDLOG_VER_MINOR, SPDLOG_VER_PATCH, CLI11_VERSION);
}

/// CLI11's own check prints the largest double.
std::string positive_seconds(const std::string& written) {
    double seconds = 0.0;
    if (CLI::detail::lexical_cast(written, seconds) && seconds > 0.0) return "";
    return fmt::format("'{}' must be a number of seconds greater than 0", written);
}

void add_engine_options(CLI::App& command, EngineOptions& options) {
    auto* scene_file = command.add_option("SCENE", options.scene_file, "scene file (TOML)");
    auto* out = command.add_option("-o,--out", options.out, "folder for what the run leaves");
    auto* resume =
        command.add_option("--resume", options.resume, "go on with the run in this folder, from its checkpoint");
    command.add_option("--set", options.overrides, "section.key=value, wins over the file; may be given again")
        ->take_all()
        ->allow_extra_args(false)
        ->excludes(resume);
    command.add_flag("--overwrite", options.overwrite, "replace what an earlier run left in the folder")
        ->excludes(resume);
    command
        .add_option("--max-walltime", options.max_walltime,
                    "stop with a checkpoint after so many seconds (exit code 75)")
        ->check(positive_seconds);
    command.add_option("--checkpoint-every", options.checkpoint_every, "seconds between checkpoints")
        ->check(positive_seconds);
    command.add_flag("--as-child", options.as_child)->group("");
    resume->excludes(scene_file)->excludes(out);
    command.callback([&options] {
        if (options.resume.empty() && options.scene_file.empty()) throw CLI::RequiredError("SCENE (or --resume DIR)");
        if (options.resume.empty() && options.out.empty()) throw CLI::RequiredError("--out DIR");
    });
}

void add_pattern_options(CLI::App& command, PatternsOptions& options) {
    command.add_option("DIR", options.folder, "run folder")->required();
    command.add_option("--phase", options.phase, "ft of the maps looked at; default 0.25");
    command.add_option("--from", options.first, "first cycle; default: the scene's settling time");
    command.add_option("--cycles", options.cycles, "how many; default: all that follow")
        ->check(CLI::Range(1, 1000000000));
    command.add_option("--waves", options.waves, "how many waves of the box are told of, the strongest; default 5")
        ->check(CLI::Range(1, 1000000));
    command.add_flag("--json", options.json, "one line of JSON");
}

void add_swift_hohenberg_options(CLI::App& command, SwiftHohenbergOptions& options) {
    auto& p = options.parameters;
    command.add_option("--control", options.controls, "epsilon; several may be given, separated by commas")
        ->delimiter(',')
        ->required();
    command.add_option("--noise", p.noise, "strength F of the noise; default 0");
    command.add_option("--points", p.points, "along each side; default 42");
    command.add_option("--side", p.side, "of the square; default 4 pi, two wavelengths");
    command.add_option("--step", p.step, "in time; default 0.5");
    command.add_option("--settle", options.settle, "steps before averaging; default 8000")
        ->check(CLI::Range(std::int64_t{0}, std::int64_t{1000000000}));
    command.add_option("--average", options.average, "steps averaged over; default 2000")
        ->check(CLI::Range(std::int64_t{10}, std::int64_t{1000000000}));
    command.add_option("--seed", p.seed, "of the noise; default 1");
}

void add_fit_noise_options(CLI::App& command, FitNoiseOptions& options) {
    command.add_option("TABLE", options.table, "CSV with columns value, mean_square, order (and their errors)")
        ->required();
    command.add_option("--noises", options.noises, "strengths F tried, ascending, separated by commas")->delimiter(',');
    command.add_option("--lowest", options.lowest, "control of the model; default -0.2");
    command.add_option("--highest", options.highest, "default 0.2");
    command.add_option("--controls", options.controls, "how many; default 17")->check(CLI::Range(4, 10000));
    command.add_option("--settle", options.settle, "steps; default 8000")->check(CLI::Range(0, 1000000000));
    command.add_option("--average", options.average, "steps; default 2000")->check(CLI::Range(1, 1000000000));
    command.add_option("--seeds", options.seeds, "averaged over; default 1")->check(CLI::Range(1, 1000));
    command.add_option("--seed", options.seed, "the first; default 1");
    command.add_option("--model", options.model,
                       "CSV of the model's curves: read if it is there, else made; default: made as TABLE.model.csv");
    command.add_flag("--onset-by-size", options.onset_by_size,
                     "the onset is where <psi^2> rises most steeply (patterns without order), not P_max");
    command.add_option("--draws", options.draws, "of the bootstrap; default 200")->check(CLI::Range(2, 1000000));
}

void add_closure_options(CLI::App& command, ClosureOptions& options) {
    auto* name = command.add_option("NAME", options.name, "of the closure; without: the list of them");
    auto* nu = command.add_option("--nu", options.volume_fractions, "volume fraction; several, separated by commas")
                   ->delimiter(',')
                   ->needs(name);
    command.add_option("--T", options.temperature, "granular temperature in g sigma; default 1")->needs(name);
    command.add_option("--e", options.restitution, "constant coefficient of restitution; default 1")->needs(name);
    command.add_option("--pair-correlation", options.pair_correlation, "at contact; default goldshtein")->needs(name);
    command.add_flag("--json", options.json, "one line of JSON");
    command.callback([name, nu] {
        if (*name && !*nu) throw CLI::RequiredError("--nu");
    });
}

void add_plan_options(CLI::App& command, PlanOptions& options) {
    command.add_option("SCENE", options.scene_file, "scene file (TOML)")->required();
    auto* error = command.add_option("--error", options.error, "wished error of z_cm(ft), 1% or 0.01, of each engine");
    auto* seconds = command
                        .add_option("--seconds", options.seconds,
                                    "wished processor time of both engines together, in place of an error")
                        ->check(positive_seconds)
                        ->excludes(error);
    command.add_option("--set", options.overrides, "section.key=value, wins over the file; may be given again")
        ->take_all()
        ->allow_extra_args(false);
    command.add_option("-o,--out", options.out, "scene file to write; default: NAME.plan.toml here");
    command.add_flag("--overwrite", options.overwrite, "replace that file");
    command.add_flag("--json", options.json, "one line of JSON");
    command.callback([error, seconds] {
        if (!*error && !*seconds) throw CLI::RequiredError("--error or --seconds");
    });
}

/// What to say of a mistyped subcommand, of which CLI11 says nothing; empty if there is none.
std::string unknown_command(const CLI::App& command, int argc, char** argv) {
    if (argc < 2 || argv[1][0] == '-') return "";
    std::vector<std::string> known;
    for (const CLI::App* sub : command.get_subcommands(nullptr)) known.push_back(sub->get_name());
    const std::string written = argv[1];
    if (std::find(known.begin(), known.end(), written) != known.end()) return "";
    std::string message = fmt::format("unknown command '{}'; known: {}", written, fmt::join(known, ", "));
    const std::string near = scene::nearest_word(written, known);
    return near.empty() ? message : message + fmt::format("; did you mean {}?", near);
}

struct SceneOptions {
    std::filesystem::path scene_file;
    std::vector<std::string> overrides;
    bool keys = false, markdown = false;
    std::string kind;  // of --keys; empty: every kind
};

void add_scene_options(CLI::App& command, SceneOptions& options) {
    auto* scene_file = command.add_option("SCENE", options.scene_file, "scene file (TOML)");
    command.add_option("--set", options.overrides, "section.key=value, wins over the file")
        ->take_all()
        ->allow_extra_args(false);
    auto* keys = command
                     .add_flag("--keys", options.keys,
                               "every key of every kind with its unit, range, default and meaning, and every name")
                     ->excludes(scene_file);
    auto* kind = command.add_option("--kind", options.kind, "of --keys: this kind alone")
                     ->check(CLI::IsMember(scene::kind_names()))
                     ->needs(keys);
    command.add_flag("--markdown", options.markdown, "of --keys: as docs/scene_keys.md")->needs(keys)->excludes(kind);
    command.callback([&options] {
        if (!options.keys && options.scene_file.empty()) throw CLI::RequiredError("SCENE (or --keys)");
    });
}

/// A commented scene of each kind, or of one, and the names that keys are chosen from.
std::string keys_as_scenes(const std::string& of_kind) {
    std::string text;
    for (std::size_t k = 0; k < scene::kind_names().size(); ++k)
        if (of_kind.empty() || of_kind == scene::kind_names()[k])
            text += scene::list_parameters(static_cast<scene::Kind>(k), compare::both_engines()) + "\n";
    return text + scene::list_names(compare::both_engines());
}

std::string scene_as_text(const SceneOptions& options) {
    if (options.markdown) return scene::key_reference(compare::both_engines());
    if (options.keys) return keys_as_scenes(options.kind);
    return scene::print_scene(continuum::resolve(compare::read_scene(options.scene_file, options.overrides)));
}

/// To stderr, whether or not it can be written: the exit code says it too.
void say(const std::string& text) { std::fputs(text.c_str(), stderr); }

int refuse_usage(const std::string& message) {
    say(fmt::format("shaken: {}\nTry: shaken --help\n", message));
    return exit_code::usage;
}

int dispatch(int argc, char** argv) {
    CLI::App command(
        "Shaken granular layers: event-driven molecular dynamics and granular hydrodynamics, side by side.", "shaken");
    command.set_version_flag("--version", version_text());
    command.require_subcommand(1);
    command.fallthrough();
    bool quiet = false, verbose = false;
    command.add_flag("-q,--quiet", quiet, "say nothing but results and errors");
    command.add_flag("-v,--verbose", verbose, "say more");

    EngineOptions options;
    std::filesystem::path folder;
    int code = exit_code::done;
    auto* run = command.add_subcommand("run", "both engines of a scene at once, then comparison and report");
    auto* md = command.add_subcommand("md", "the molecular dynamics of a scene");
    auto* continuum = command.add_subcommand("continuum", "the hydrodynamics of a scene");
    for (CLI::App* engine : {run, md, continuum}) add_engine_options(*engine, options);
    auto* compare =
        command.add_subcommand("compare", "compare what both engines left in a folder: compare.h5, summary.json");
    auto* report = command.add_subcommand("report", "draw the figures and report.html of a compared folder");
    report->add_option("DIR", folder, "run folder")->required();
    CompareOptions compare_options;
    compare->add_option("DIR", compare_options.folder, "run folder, or where to put a comparison of others")
        ->required();
    compare->add_option("--md", compare_options.md, "run folder of the MD; several are averaged (default: DIR)")
        ->allow_extra_args(false);
    compare->add_option("--continuum", compare_options.continuum, "run folder of the continuum (default: DIR)");
    compare->add_flag("--first-cycle", compare_options.first_cycle,
                      "of runs that start from a file: one cycle, from the phase where they started");
    PatternsOptions patterns_options;
    auto* patterns = command.add_subcommand("patterns", "size, order and growth of a run's horizontal pattern");
    add_pattern_options(*patterns, patterns_options);
    SwiftHohenbergOptions model_options;
    auto* swift_hohenberg =
        command.add_subcommand("swift-hohenberg", "steady states of the noisy Swift-Hohenberg equation");
    add_swift_hohenberg_options(*swift_hohenberg, model_options);
    FitNoiseOptions fit_options;
    auto* fit_noise = command.add_subcommand("fit-noise", "noise and mean-field onset of a measured onset of patterns");
    add_fit_noise_options(*fit_noise, fit_options);
    PlanOptions plan_options;
    auto* plan = command.add_subcommand("plan", "propose grid, cycles and seeds of a scene for a wished error or time");
    add_plan_options(*plan, plan_options);
    ClosureOptions closure_options;
    auto* closure = command.add_subcommand("closure", "pressure, sound and transport of a gas by a closure's name");
    add_closure_options(*closure, closure_options);
    auto* scene_command = command.add_subcommand("scene", "print the resolved scene, or the list of all keys");
    SceneOptions scene_options;
    add_scene_options(*scene_command, scene_options);

    auto* bench = command.add_subcommand("bench", "how fast the engines are on this machine, as one line of JSON");
    bench->require_subcommand(1);
    MdBench md_options;
    auto* bench_md = bench->add_subcommand("md", "a uniform elastic gas, or a scene");
    auto* bench_scene =
        bench_md->add_option("SCENE", md_options.scene_file, "scene file; without: a uniform elastic gas");
    bench_md->add_option("--set", md_options.overrides, "section.key=value")
        ->take_all()
        ->allow_extra_args(false)
        ->needs(bench_scene);
    bench_md->add_option("--cycles", md_options.cycles, "cycles timed")
        ->check(CLI::Range(1, 1000000))
        ->needs(bench_scene);
    bench_md->add_option("--settle", md_options.settle, "cycles before timing")
        ->check(CLI::Range(0, 1000000))
        ->needs(bench_scene);
    bench_md->add_option("--particles", md_options.particles, "of the gas")
        ->check(CLI::Range(2, 100000000))
        ->excludes(bench_scene);
    bench_md->add_option("--volume-fraction", md_options.volume_fraction, "of the gas")
        ->check(CLI::Range(1e-6, 0.6))
        ->excludes(bench_scene);
    bench_md->add_option("--collisions", md_options.collisions, "pair collisions timed")
        ->check(CLI::Range(std::int64_t{1}, std::int64_t{1000000000000}))
        ->excludes(bench_scene);
    ContinuumBench continuum_options;
    auto* bench_continuum = bench->add_subcommand("continuum", "a shaken layer on a grid");
    bench_continuum->add_option("--dimension", continuum_options.dimension, "1, 2 or 3")->check(CLI::Range(1, 3));
    bench_continuum->add_option("--cells", continuum_options.cells, "NZ, NXxNZ or NXxNYxNZ");
    bench_continuum->add_option("--steps", continuum_options.steps, "steps timed")->check(CLI::Range(1, 100000000));
    bench_continuum->add_option("--scheme", continuum_options.scheme, "as in [continuum] scheme");

    if (const std::string message = unknown_command(command, argc, argv); !message.empty())
        return refuse_usage(message);
    try {
        command.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return command.exit(error);  // --help, --version
        return refuse_usage(error.what());
    }
    options.quiet = quiet;
    spdlog::set_level(quiet ? spdlog::level::warn : verbose ? spdlog::level::debug : spdlog::level::info);

    if (*run) code = run_both(options);
    if (*md) code = run_md(options);
    if (*continuum) code = run_continuum(options);
    if (*bench && *bench_md) code = run_md_bench(md_options);
    if (*bench && *bench_continuum) code = run_continuum_bench(continuum_options);
    if (*compare) code = run_compare(compare_options);
    if (*patterns) code = run_patterns(patterns_options);
    if (*swift_hohenberg) code = run_swift_hohenberg(model_options);
    if (*fit_noise) code = run_fit_noise(fit_options);
    if (*plan) code = run_plan(plan_options);
    if (*closure) code = run_closure(closure_options);
    if (*report) code = run_report(folder);
    if (*scene_command) fmt::print("{}", scene_as_text(scene_options));
    return code;
}

int refuse(const std::exception& error, int code) {
    say(fmt::format("shaken: {}\n", error.what()));
    return code;
}

int refuse_stdout() { return refuse(files::WriteFailed("stdout: cannot be written"), exit_code::write_failed); }

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file past the size limit is then a failed write, with its sentence and code
    spdlog::set_default_logger(spdlog::stderr_logger_st("shaken"));
    spdlog::set_pattern("shaken: %v");
    try {
        const int code = dispatch(argc, argv);
        return std::fflush(stdout) == 0 ? code : refuse_stdout();
    } catch (const scene::SceneError& error) {
        return refuse(error, exit_code::bad_input);
    } catch (const scene::NoSceneFile& error) {
        return refuse(error, exit_code::no_input);
    } catch (const files::NoInput& error) {
        return refuse(error, exit_code::no_input);
    } catch (const files::Damaged& error) {
        return refuse(error, exit_code::bad_input);
    } catch (const md::CannotSetUp& error) {
        return refuse(error, exit_code::bad_input);
    } catch (const files::CannotCreate& error) {
        return refuse(error, exit_code::cannot_create);
    } catch (const files::WriteFailed& error) {
        return refuse(error, exit_code::write_failed);
    } catch (const UsageError& error) {
        return refuse(error, exit_code::usage);
    } catch (const std::bad_alloc&) {
        return refuse(std::runtime_error("not enough memory for this scene"), exit_code::run_failed);
    } catch (const std::exception& error) {
        if (std::ferror(stdout)) return refuse_stdout();  // as a long print says it
        return refuse(error, exit_code::run_failed);
    }
}
