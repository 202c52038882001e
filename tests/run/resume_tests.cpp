// SPDX-License-Identifier: MIT
// Outputs of runs that have not finished, made from checkpoint and stream.
#include "run/resume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "files/errors.hpp"
#include "files/hdf5.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/command.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

namespace {

/// Stops a run of 1000 cycles, 2 of settling, with frames of them all, after so many seconds.
void stop(const std::string& engine, const std::string& out, const std::string& seconds) {
    REQUIRE(support::shaken("-q " + engine + " " + support::small_scene + " --set sample.average=998 --out " + out +
                            " --set sample.frame_cycles=1000 --set sample.frames=4 --max-walltime " + seconds)
                .code == 75);
}

/// Rows, frames and maps that a file holds.
std::array<std::uint64_t, 3> held(const files::Hdf5File& file, const std::string& engine) {
    std::uint64_t frames = 0;
    if (engine == "md")
        frames = file.shape("/particles/all/position/value")[0];
    else
        while (file.has(fmt::format("/frames/{:05}", frames))) ++frames;
    return {file.shape("/observables/centre_of_mass/value")[0], frames, file.shape("/height_maps/height")[0]};
}

}  // namespace

TEST_CASE("a stopped run's file holds every row, frame and map up to its checkpoint") {
    const std::string engine = GENERATE("md", "continuum");
    const support::TemporaryFolder folder;
    const std::string out = (folder / "run").string();
    stop(engine, out, "0.6");
    const run::EngineFiles files{out, engine};
    run::restore_outputs(out);
    const std::int64_t reached = run::read_checkpoint(files).next_sample;
    const files::Hdf5File file(files.output(), files::Open::read);
    const auto every_25 = static_cast<std::uint64_t>((reached + 24) / 25);
    REQUIRE(reached > 0);
    CHECK(held(file, engine) == std::array{static_cast<std::uint64_t>(reached), every_25, every_25});
    CHECK(file.shape("/profiles/centre_of_mass") == files::Shape{998, 100});
    const auto heights = file.read<double>("/profiles/centre_of_mass");
    const auto known = std::count_if(heights.begin(), heights.end(), [](double height) { return !std::isnan(height); });
    CHECK(known == std::max<std::int64_t>(0, reached - 200));
    CHECK(file.read_text("/provenance/parent") == files.checkpoint().string());
}

TEST_CASE("compare averages over what stopped runs have reached, and says over how many cycles") {
    const support::TemporaryFolder folder;
    const std::string out = (folder / "run").string();
    stop("md", out, "2");
    const std::string continuum = (folder / "continuum").string();
    stop("continuum", continuum, "1");
    const auto compared = support::shaken("compare " + out + " --continuum " + continuum);
    INFO(compared.text);
    REQUIRE(compared.code == 0);
    CHECK_THAT(compared.text, Contains("An MD run was stopped on its way: averages are over ") &&
                                  Contains("The continuum was stopped on its way: averages are over ") &&
                                  Contains(" of 998 cycles."));
}

TEST_CASE("patterns of a stopped run are of the cycles that it has") {
    const support::TemporaryFolder folder;
    const std::string out = (folder / "run").string();
    stop("md", out, "1");
    const auto patterns = support::shaken("patterns " + out);
    INFO(patterns.text);
    REQUIRE(patterns.code == 0);
    CHECK_THAT(patterns.text, !Contains("to 999"));
}

TEST_CASE("a finished run and one at work are left alone") {
    const support::TemporaryFolder folder;
    const std::string out = (folder / "run").string();
    REQUIRE(support::shaken(std::string("-q md ") + support::small_scene + " --out " + out).code == 0);
    const run::EngineFiles files{out, "md"};
    CHECK(run::read_checkpoint(files).is_finished);
    const auto written = std::filesystem::last_write_time(files.output());
    run::restore_outputs(out);
    CHECK(std::filesystem::last_write_time(files.output()) == written);
    stop("continuum", (folder / "other").string(), "0.1");
    const run::FolderLock at_work(folder / "other", "continuum");
    CHECK_THROWS_AS(run::restore_outputs(folder / "other"), files::CannotCreate);
}

TEST_CASE("a scene with an exact solution hears its time limit, begins anew and says where its file is from") {
    const support::TemporaryFolder folder;
    const std::string out = (folder / "run").string();
    const std::string scene = SHAKEN_SOURCE_DIR "/data/scenes/verify_wave.toml";
    CHECK(support::shaken("-q continuum " + scene + " --max-walltime 1e-6 --out " + out).code == 75);
    CHECK_FALSE(std::filesystem::exists(out + "/summary.json"));
    REQUIRE(support::shaken("-q continuum --resume " + out).code == 0);
    CHECK(std::filesystem::exists(out + "/summary.json"));
    const files::Hdf5File file(out + "/continuum.h5", files::Open::read);
    CHECK(file.read_text("/provenance/scene") == support::content_of(out + "/scene.toml"));
    CHECK(file.read_text("/provenance/parent") == out + "/continuum.checkpoint");
    CHECK_FALSE(file.read<double>("/verification/velocity").empty());
    CHECK(support::shaken("-q continuum --resume " + out).code == 0);  // complete
}
