// SPDX-License-Identifier: MIT
// How a child ends is how its parent ends: from the process to `shaken run`.
#include "app/child_process.hpp"

#include <filesystem>

#include "tests/support/catch.hpp"
#include "tests/support/command.hpp"
#include "tests/support/temporary_folder.hpp"

using shaken::app::ChildProcess;

namespace {

int code_of(const std::string& script) { return ChildProcess("sh", {"-c", script}, ChildProcess::Kind::silent).wait(); }

/// Runs both engines of the small layer with this changed.
support::Result run_with(const std::string& change, const support::TemporaryFolder& folder) {
    return support::shaken(std::string("-q run ") + support::small_scene + " --set " + change + " --out " +
                           (folder / "run").string());
}

}  // namespace

TEST_CASE("a child's code is its own, 128 and the signal that killed it, or 127 where it is not there") {
    for (const int code : {0, 1, 65, 74, 75}) CHECK(code_of("exit " + std::to_string(code)) == code);
    CHECK(code_of("kill -KILL $$") == 128 + 9);
    CHECK(code_of("kill -SEGV $$") == 128 + 11);
    CHECK(ChildProcess("/no/such/program", {}, ChildProcess::Kind::silent).wait() == 127);
}

TEST_CASE("a run whose continuum fails ends as the continuum does, and says which engine it was") {
    const support::TemporaryFolder folder;
    const auto frozen = run_with("continuum.floor_temperature=0.5 --set particles.restitution=0.6", folder);
    CHECK(frozen.code == 1);
    CHECK_THAT(frozen.text, Contains("continuum failed with exit code 1") && Contains("temperature floor"));
}

TEST_CASE("a run whose grains collapse ends as the MD does, and says which engine it was") {
    const support::TemporaryFolder folder;
    const auto stalled = run_with("particles.restitution=0.2", folder);
    CHECK(stalled.code == 1);
    CHECK_THAT(stalled.text, Contains("md failed with exit code 1") && Contains("inelastic collapse"));
}

TEST_CASE("a run of which an engine is killed says by what") {
    const support::TemporaryFolder folder;
    const std::string out = (folder / "run").string();
    // The engine that has no checkpoint yet may not be there yet either.
    const auto killed = support::shell(SHAKEN_COMMAND " -q run " + std::string(support::small_scene) +
                                       " --set sample.average=2000 --out " + out + " & run=$!; until [ -e " + out +
                                       "/md.checkpoint -a -e " + out +
                                       "/continuum.checkpoint ] || ! kill -0 $run; do sleep 0.02; done; "
                                       "set -- $(cat /proc/$run/task/$run/children); kill -KILL $1; wait $run");
    INFO(killed.text);
    CHECK(killed.code == 128 + 9);
    CHECK_THAT(killed.text, Contains("md failed with exit code 137"));
}
