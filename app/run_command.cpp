// SPDX-License-Identifier: MIT
#include "app/run_command.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "app/child_process.hpp"
#include "app/compare_command.hpp"
#include "app/engine_command.hpp"
#include "app/exit_codes.hpp"
#include "app/progress.hpp"
#include "app/signals.hpp"
#include "app/start_keys.hpp"
#include "continuum/resolve.hpp"
#include "continuum/solver.hpp"
#include "files/atomic_write.hpp"
#include "run/folder.hpp"
#include "compare/scenes.hpp"
#include "scene/read_scene.hpp"

namespace shaken::app {

namespace {

run::Status status_of(const run::EngineFiles& files) {
    std::ostringstream text;
    text << std::ifstream(files.status()).rdbuf();
    try {
        return run::Status::from_json(text.str());
    } catch (const std::exception&) {
        run::Status starting;
        starting.engine = files.engine;
        starting.remaining = HUGE_VAL;
        return starting;
    }
}

std::vector<std::string> child_arguments(const run::EngineFiles& files, const EngineOptions& options) {
    std::vector<std::string> arguments{files.engine, "--quiet", "--as-child"};
    if (std::filesystem::exists(files.checkpoint())) {
        arguments.insert(arguments.end(), {"--resume", files.folder.string()});
    } else {
        arguments.insert(arguments.end(), {(files.folder / "scene.toml").string(), "--out", files.folder.string()});
    }
    if (std::isfinite(options.max_walltime)) {
        arguments.insert(arguments.end(), {"--max-walltime", fmt::format("{}", options.max_walltime)});
    }
    arguments.insert(arguments.end(), {"--checkpoint-every", fmt::format("{}", options.checkpoint_every)});
    return arguments;
}

/// Waits for both; passes on signals; when one fails, asks the other to stop with a checkpoint.
std::array<int, 2> wait_for(std::array<ChildProcess, 2>& children, const std::array<run::EngineFiles, 2>& files,
                            bool quiet) {
    ProgressDisplay display(quiet);
    bool told_to_stop = false;
    const auto tell = [&](int number) {
        for (const ChildProcess& child : children) child.signal(number);
    };
    const auto statuses = [&] { return std::vector<run::Status>{status_of(files[0]), status_of(files[1])}; };
    for (;;) {
        const std::array<std::optional<int>, 2> codes{children[0].poll(), children[1].poll()};
        const bool failed = codes[0].value_or(0) != 0 || codes[1].value_or(0) != 0;
        if ((failed || stop_requested()) && !told_to_stop) {
            tell(SIGTERM);
            told_to_stop = true;
        }
        if (take_checkpoint_request()) tell(SIGUSR1);
        if (codes[0] && codes[1]) {
            display.finish(statuses());
            return {*codes[0], *codes[1]};
        }
        if (display.is_due()) display.draw(statuses());
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
}

}  // namespace

int run_both(const EngineOptions& options) {
    const std::filesystem::path folder = options.resume.empty() ? options.out : options.resume;
    catch_signals();
    if (options.resume.empty()) {
        const scene::Scene scene = continuum::resolve(compare::read_scene(options.scene_file, options.overrides));
        refuse_verification(scene, "run");
        refuse_uniform(scene, "run");
        refuse_phase_without_file(scene);
        // The hydrodynamics check their names and sizes here, before the MD begins in vain.
        continuum::Solver{scene};
        run::prepare_folder(folder, options.overwrite, scene::print_scene(scene));
        files::write_atomically(folder / "scene.toml", scene::print_scene(scene));
        for (const std::string& note : notes_of_continuum_start(scene, true)) fmt::print("note: {}\n", note);
    } else {
        compare::read_scene(folder / "scene.toml");
    }
    const run::FolderLock lock(folder, "run");
    const std::array<run::EngineFiles, 2> files{run::EngineFiles{folder, "md"}, run::EngineFiles{folder, "continuum"}};
    // Both engines share the cores: a thread that waits must not burn what the other engine needs.
    setenv("OMP_WAIT_POLICY", "passive", 0);
    const std::string self = own_path().string();
    constexpr auto listening = ChildProcess::Kind::listening;
    std::array<ChildProcess, 2> children{ChildProcess(self, child_arguments(files[0], options), listening),
                                         ChildProcess(self, child_arguments(files[1], options), listening)};
    const std::array<int, 2> codes = wait_for(children, files, options.quiet);

    for (std::size_t i = 0; i < 2; ++i) {
        if (codes[i] != exit_code::done && codes[i] != exit_code::stopped) {
            spdlog::error("{} failed with exit code {}; what the other engine wrote is in {}", files[i].engine,
                          codes[i], folder.string());
            return codes[i];
        }
    }
    const auto stopped = [&] {
        spdlog::warn("stopped; go on with: shaken run --resume {}", folder.string());
        return exit_code::stopped;
    };
    if (codes[0] == exit_code::stopped || codes[1] == exit_code::stopped || stop_requested()) return stopped();
    run_compare({folder, {}, {}, false});
    if (stop_requested() || run_report(folder) == exit_code::stopped) return stopped();
    spdlog::info("the report is {}", (folder / "report.html").string());
    return exit_code::done;
}

}  // namespace shaken::app
