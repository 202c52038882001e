// SPDX-License-Identifier: MIT
// A signal is neither lost nor deadly, whenever it comes: before a child listens, while engines run, while figures are
// drawn.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include "app/child_process.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/command.hpp"
#include "tests/support/temporary_folder.hpp"

using shaken::app::ChildProcess;

namespace {

/// The small layer, too long to end by itself while a test looks.
ChildProcess begin(const std::string& command, const std::string& out) {
    return {SHAKEN_COMMAND,
            {"-q", command, support::small_scene, "--set", "sample.average=2000", "--out", out},
            ChildProcess::Kind::listening};
}

void wait_for_file(const std::filesystem::path& path) {
    for (int tries = 0; tries < 3000 && !std::filesystem::exists(path); ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    REQUIRE(std::filesystem::exists(path));
}

}  // namespace

TEST_CASE("an engine that is asked to stop as soon as it is born stops with a checkpoint") {
    const std::string engine = GENERATE("md", "continuum");
    const support::TemporaryFolder folder;
    for (int birth = 0; birth < 30; ++birth) {
        const std::string out = (folder / std::to_string(birth)).string();
        ChildProcess child = begin(engine, out);
        std::this_thread::sleep_for(std::chrono::microseconds(300 * birth));
        child.signal(SIGUSR1);
        child.signal(SIGTERM);
        INFO(engine << " after " << 300 * birth << " us");
        REQUIRE(child.wait() == 75);
        REQUIRE(std::filesystem::exists(out + "/" + engine + ".checkpoint"));
    }
}

TEST_CASE("a run that is asked to stop early stops with both checkpoints") {
    const support::TemporaryFolder folder;
    for (int birth = 0; birth < 10; ++birth) {
        const std::string out = (folder / std::to_string(birth)).string();
        ChildProcess run = begin("run", out);
        std::this_thread::sleep_for(std::chrono::milliseconds(5 * birth));
        run.signal(SIGTERM);
        INFO("after " << 5 * birth << " ms");
        REQUIRE(run.wait() == 75);
        for (const char* engine : {"md", "continuum"})
            REQUIRE(std::filesystem::exists(out + "/" + engine + ".checkpoint"));
    }
}

TEST_CASE("a run whose disk is full says so, whatever the engine that is told to stop was doing") {
    const support::TemporaryFolder folder;
    for (int birth = 0; birth < 14; ++birth) {
        const auto full =
            support::shell("ulimit -f 60; " SHAKEN_COMMAND " -q run " + std::string(support::small_scene) + " --out " +
                           (folder / std::to_string(birth)).string());
        INFO("run " << birth << ": " << full.text);
        REQUIRE(full.code == 74);
    }
}

TEST_CASE("a run that is stopped while it draws says so and can go on") {
    const support::TemporaryFolder folder;
    const std::string out = (folder / "a").string();
    ChildProcess run(SHAKEN_COMMAND, {"-q", "run", support::small_scene, "--out", out}, ChildProcess::Kind::listening);
    wait_for_file(out + "/summary.json");
    run.signal(SIGTERM);
    CHECK(run.wait() == 75);
    CHECK_FALSE(std::filesystem::exists(out + "/report.html"));
    CHECK(std::filesystem::exists(out + "/md.checkpoint"));
}
