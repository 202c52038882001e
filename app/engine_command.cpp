// SPDX-License-Identifier: MIT
#include "app/engine_command.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <fstream>
#include <sstream>

#include "app/continuum_run.hpp"
#include "app/engine_loop.hpp"
#include "app/exit_codes.hpp"
#include "app/md_run.hpp"
#include "app/run_folder.hpp"
#include "app/start_keys.hpp"
#include "app/uniform_run.hpp"
#include "app/verification_run.hpp"
#include "compare/scenes.hpp"
#include "continuum/errors.hpp"
#include "continuum/resolve.hpp"
#include "files/atomic_write.hpp"
#include "files/errors.hpp"
#include "files/hdf5.hpp"
#include "scene/errors.hpp"
#include "scene/read_scene.hpp"

namespace shaken::app {

namespace {

void print_result(const MdRun& run) {
    const md::Counters c = run.counters();
    fmt::print("md: {} pair collisions, {} with the plate, state {:016x}\n", c.pair_collisions, c.plate_collisions,
               run.state_hash());
}

void print_result(const UniformRun& run) {
    fmt::print("md: {} pair collisions, state {:016x}\n", run.counters().pair_collisions, run.state_hash());
    for (const Measured& m : run.results()) {
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

void print_result(const ContinuumRun& run) {
    fmt::print("continuum: {} steps, state {:016x}\n", run.steps(), run.state_hash());
    fmt::print("validity: {}\n", compare::in_words(run.validity()));
    for (const std::string& note : run.notes()) fmt::print("note: {}\n", note);
}

template <class Run>
int finish(Run& run, const scene::Scene& scene, const EngineFiles& files, const EngineOptions& options, Spent before,
           const std::string& parent) {
    EngineLoop<Run> loop(run, files, options, before);
    try {
        if (loop.go() == Outcome::stopped) {
            spdlog::warn("{}: stopped; go on with: shaken {} --resume {}", run.name(), run.name(),
                         files.folder.string());
            return exit_code::stopped;
        }
        run.write(files.output(), loop.spent(), parent);
    } catch (const continuum::RunFailed&) {
        loop.keep_last_state();
        loop.finish("failed");
        throw;
    } catch (...) {
        loop.finish("failed");
        throw;
    }
    loop.finish("finished");
    if (options.as_child) return exit_code::done;
    print_result(run);
    const Notes notes = run.name() == "md" ? notes_of_start(scene) : notes_of_continuum_start(scene, false);
    for (const std::string& note : notes) fmt::print("note: {}\n", note);
    return exit_code::done;
}

template <class Run>
int start(const std::string& engine, const EngineOptions& options) {
    scene::Scene scene = compare::read_scene(options.scene_file, options.overrides);
    // A child of `run` prints what its parent has printed, resolved for both engines.
    if (engine == "continuum" || options.as_child) scene = continuum::resolve(std::move(scene));
    if (engine == "continuum" && (is_verification(scene.kind) || scene.kind == scene::Kind::uniform))
        return run_verification(scene, options);
    refuse_verification(scene, engine);
    refuse_phase_without_file(scene);
    catch_signals();
    const EngineFiles files{options.out, engine};
    // Whatever the scene gets wrong shows here, before anything of an earlier run is removed.
    Run run(scene);
    if (!options.as_child) prepare_folder(files.folder, options.overwrite, scene::print_scene(scene));
    const FolderLock lock(files.folder, engine);
    if (!options.as_child) files::write_atomically(files.folder / "scene.toml", scene::print_scene(scene));
    return finish(run, scene, files, options, {}, "");
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
    const EngineFiles files{options.resume, engine};
    if (!std::filesystem::is_directory(files.folder)) {
        throw files::NoInput(fmt::format("{}: no such run folder", files.folder.string()));
    }
    catch_signals();
    const FolderLock lock(files.folder, engine);
    const files::CheckpointReader in(files.checkpoint());
    if (in.take_text("engine") != engine) {
        throw files::Damaged(fmt::format("{}: is a checkpoint of {}, not of {}", files.checkpoint().string(),
                                         in.take_text("engine"), engine));
    }
    refuse_edited_scene(files.folder / "scene.toml", in.take_text("scene"));
    const scene::Scene scene = compare::parse_scene(in.take_text("scene"), files.checkpoint().string() + " (scene)");
    Run run(scene);
    run.restore(in);
    if (run.next_sample() == run.samples() && files::Hdf5File::is_readable(files.output())) {
        spdlog::info("{}: {} is complete", engine, files.output().string());
        return exit_code::done;
    }
    return finish(run, scene, files, options, in.take_one<Spent>("spent"), files.checkpoint().string());
}

template <class Run>
int start_or_resume(const std::string& engine, const EngineOptions& options) {
    return options.resume.empty() ? start<Run>(engine, options) : resume<Run>(engine, options);
}

/// Of the scene to start with, or of the one begun with; a checkpoint that cannot be read is refused by whoever resumes
/// from it.
scene::Kind kind_of(const EngineOptions& options) {
    if (options.resume.empty()) return compare::read_scene(options.scene_file, options.overrides).kind;
    const EngineFiles files{options.resume, "md"};
    if (!std::filesystem::exists(files.checkpoint())) return scene::Kind::layer;
    const files::CheckpointReader in(files.checkpoint());
    return compare::parse_scene(in.take_text("scene"), files.checkpoint().string() + " (scene)").kind;
}

}  // namespace

void refuse_uniform(const scene::Scene& scene, const std::string& command) {
    if (scene.kind == scene::Kind::uniform)
        throw scene::SceneError(
            {}, fmt::format("shaken {}: a scene of kind uniform is for one engine at a time; run it with: "
                            "shaken md or shaken continuum",
                            command));
}

int run_md(const EngineOptions& options) {
    if (kind_of(options) == scene::Kind::uniform) return start_or_resume<UniformRun>("md", options);
    return start_or_resume<MdRun>("md", options);
}
int run_continuum(const EngineOptions& options) { return start_or_resume<ContinuumRun>("continuum", options); }

}  // namespace shaken::app
