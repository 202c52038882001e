// SPDX-License-Identifier: MIT
#include "app/engine_command.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <fstream>
#include <sstream>
#include <type_traits>

#include "app/exit_codes.hpp"
#include "app/progress.hpp"
#include "app/signals.hpp"
#include "app/start_keys.hpp"
#include "compare/scenes.hpp"
#include "continuum/errors.hpp"
#include "continuum/resolve.hpp"
#include "files/atomic_write.hpp"
#include "files/errors.hpp"
#include "files/hdf5.hpp"
#include "run/continuum_layer.hpp"
#include "run/driver.hpp"
#include "run/md_gas.hpp"
#include "run/md_layer.hpp"
#include "run/resume.hpp"
#include "run/verification.hpp"
#include "scene/errors.hpp"
#include "scene/read_scene.hpp"

namespace shaken::app {

namespace {

void print_result(const run::MdLayer& run) {
    const md::Counters c = run.state().counters();
    fmt::print("md: {} pair collisions, {} with the plate, state {:016x}\n", c.pair_collisions, c.plate_collisions,
               run.state().state_hash());
}

void print_result(const run::MdGas& run, const std::filesystem::path& output) {
    fmt::print("md: {} pair collisions, state {:016x}\n", run.state().counters().pair_collisions,
               run.state().state_hash());
    for (const run::Measured& m : run::gas_results(run.scene(), output)) {
        // An error that may be too small is not left bare.
        fmt::print("{:40} {:.6g} +- {}{:.2g}", m.name, m.value, m.is_too_short ? "at least " : "", m.error);
        if (m.reference) fmt::print("   {:.6g} ({})", *m.reference, m.source);
        if (m.is_too_short)
            fmt::print(", too short to tell: about {:.2g} independent samples", m.independent);
        else if (m.reference)
            fmt::print(", {:+.1f} standard errors", (m.value - *m.reference) / m.error);
        fmt::print("\n");
    }
}

void print_result(const run::ContinuumLayer& run) {
    fmt::print("continuum: {} steps, state {:016x}\n", run.state().steps(), run.state().state_hash());
    fmt::print("validity: {}\n", compare::in_words(run.record().validity()));
    for (const std::string& note : run.record().notes()) fmt::print("note: {}\n", note);
}

void print_result(const run::VerificationRun& run) {
    const continuum::Verification& v = run.found();
    fmt::print("continuum: {} cells, {} steps\n", v.height.size(), v.steps);
    for (const continuum::Checked& number : v.numbers) {
        if (number.why_no_exact.empty())
            fmt::print("{:36} {:.8g}   exact {:.8g}   error {:.3g}\n", number.name, number.computed, number.exact,
                       number.relative_error());
        else
            fmt::print("{:36} {:.8g}   no exact value: {}\n", number.name, number.computed, number.why_no_exact);
    }
    if (v.why_no_exact.empty())
        fmt::print("mean error: volume fraction {:.3g}, velocity {:.3g}, temperature {:.3g}\n", v.volume_fraction_error,
                   v.velocity_error, v.temperature_error);
    else
        fmt::print("no exact profile: {}\n", v.why_no_exact);
}

void print(const auto& run, const std::filesystem::path& output) {
    if constexpr (requires { print_result(run, output); })
        print_result(run, output);
    else
        print_result(run);
}

template <run::EngineRun Run>
int finish(Run& engine_run, const scene::Scene& scene, const run::EngineFiles& files, const EngineOptions& options,
           run::Origin origin) {
    ProgressDisplay display(options.quiet);
    const auto show = [&](const run::Status& status, bool last) {
        last ? display.finish({status}) : display.draw({status});
    };
    const run::Controls controls{stop_requested, take_checkpoint_request, show, options.max_walltime,
                                 options.checkpoint_every};
    run::Driver<Run> driver(engine_run, files, controls, std::move(origin));
    const std::string engine = engine_run.engine();
    try {
        if (driver.go() == run::Outcome::stopped) {
            spdlog::warn("{}: stopped; go on with: shaken {} --resume {}", engine, engine, files.folder.string());
            return exit_code::stopped;
        }
    } catch (const continuum::RunFailed&) {
        driver.keep_last_state();
        driver.finish("failed");
        throw;
    } catch (...) {
        driver.finish("failed");
        throw;
    }
    driver.finish("finished");
    if (options.as_child) return exit_code::done;
    print(engine_run, files.output());
    const run::Notes notes = engine == "md" ? notes_of_start(scene) : notes_of_continuum_start(scene, false);
    for (const std::string& note : notes) fmt::print("note: {}\n", note);
    return exit_code::done;
}

template <class Run>
int start(const std::string& engine, const EngineOptions& options) {
    scene::Scene scene = compare::read_scene(options.scene_file, options.overrides);
    // A child of `run` prints what its parent has printed, resolved for both engines.
    if (std::is_same_v<Run, run::VerificationRun>)
        scene = continuum::resolve_alone(std::move(scene));
    else if (engine == "continuum" || options.as_child)
        scene = continuum::resolve(std::move(scene));
    if (engine == "md") refuse_verification(scene, engine);
    refuse_phase_without_file(scene);
    catch_signals();
    const run::EngineFiles files{options.out, engine};
    // Whatever the scene gets wrong shows here, before anything of an earlier run is removed.
    Run engine_run(scene);
    if (!options.as_child) run::prepare_folder(files.folder, options.overwrite, scene::print_scene(scene));
    const run::FolderLock lock(files.folder, engine);
    if (!options.as_child) files::write_atomically(files.folder / "scene.toml", scene::print_scene(scene));
    return finish(engine_run, scene, files, options, {scene::print_scene(scene), "", {}, 0});
}

/// A resumed run goes on with the scene it began with; a scene.toml that says otherwise would be a lie beside its
/// output.
void refuse_edited_scene(const std::filesystem::path& path, const std::string& begun_with) {
    std::ifstream file(path);
    if (!file) return;
    std::istringstream wanted(begun_with);
    std::string there, here;
    for (int line = 1; std::getline(wanted, there); ++line) {
        std::getline(file, here);
        if (here != there) {
            throw scene::SceneError(
                {path.string(), line, 1, here},
                fmt::format("differs from the scene of the checkpoint, which says '{}'; start a new "
                            "run for a changed scene",
                            there));
        }
    }
}

template <class Run>
int resume(const std::string& engine, const EngineOptions& options) {
    const run::EngineFiles files{options.resume, engine};
    if (!std::filesystem::is_directory(files.folder)) {
        throw files::NoInput(fmt::format("{}: no such run folder", files.folder.string()));
    }
    catch_signals();
    const run::FolderLock lock(files.folder, engine);
    const run::Resumed from = run::read_checkpoint(files);
    refuse_edited_scene(files.folder / "scene.toml", from.origin.scene_text);
    if (from.is_finished) {
        if (!files::Hdf5File::is_readable(files.output()))
            throw files::Damaged(
                fmt::format("{}: is not readable, and the run that wrote it has finished: begin it "
                            "anew with --overwrite",
                            files.output().string()));
        std::filesystem::remove(files.stream());  // where it was killed on the last step
        spdlog::info("{}: {} is complete", engine, files.output().string());
        return exit_code::done;
    }
    Run engine_run(from.scene);
    engine_run.restore(from.in, from.next_sample);
    return finish(engine_run, from.scene, files, options, from.origin);
}

template <class Run>
int start_or_resume(const std::string& engine, const EngineOptions& options) {
    return options.resume.empty() ? start<Run>(engine, options) : resume<Run>(engine, options);
}

/// Of the scene to start with, or of the one begun with; a checkpoint that cannot be read is refused by whoever resumes
/// from it.
scene::Kind kind_of(const std::string& engine, const EngineOptions& options) {
    if (options.resume.empty()) return compare::read_scene(options.scene_file, options.overrides).kind;
    const run::EngineFiles files{options.resume, engine};
    return std::filesystem::exists(files.checkpoint()) ? run::read_checkpoint(files).scene.kind : scene::Kind::layer;
}

}  // namespace

void refuse_uniform(const scene::Scene& scene, const std::string& command) {
    if (scene.kind == scene::Kind::uniform)
        throw scene::SceneError(
            {}, fmt::format("shaken {}: a scene of kind uniform is for one engine at a time; run it with: "
                            "shaken md or shaken continuum",
                            command));
}

void refuse_verification(const scene::Scene& scene, const std::string& command) {
    if (run::is_verification(scene.kind))
        throw scene::SceneError({},
                                fmt::format("shaken {}: a scene of this kind is for the continuum alone; run it with: "
                                            "shaken continuum",
                                            command));
}

int run_md(const EngineOptions& options) {
    if (kind_of("md", options) == scene::Kind::uniform) return start_or_resume<run::MdGas>("md", options);
    return start_or_resume<run::MdLayer>("md", options);
}

int run_continuum(const EngineOptions& options) {
    if (kind_of("continuum", options) == scene::Kind::layer)
        return start_or_resume<run::ContinuumLayer>("continuum", options);
    return start_or_resume<run::VerificationRun>("continuum", options);
}

}  // namespace shaken::app
