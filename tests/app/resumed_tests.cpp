// SPDX-License-Identifier: MIT
// What the file of a resumed run says of its past: the checkpoint it goes on from, its seed, and all the time spent.
#include <chrono>
#include <filesystem>

#include "files/hdf5.hpp"
#include "run/driver.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/command.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

shaken::run::Spent spent_by(const std::filesystem::path& checkpoint) {
    return shaken::files::CheckpointReader(checkpoint).take_one<shaken::run::Spent>("spent");
}

}  // namespace

TEST_CASE("the file of a resumed run names its checkpoint, its seed and all the time spent") {
    const std::string engine = GENERATE("md", "continuum");
    const support::TemporaryFolder folder;
    const std::string out = (folder / "run").string(), checkpoint = out + "/" + engine + ".checkpoint";
    const auto start = Clock::now();
    // One thread: processor time is then not above the clock's.
    const std::string command = "OMP_NUM_THREADS=1 " SHAKEN_COMMAND " -q " + engine;
    int code = support::shell(command + " " + support::small_scene + " --set md.seed=77 --set initial.seed=78 " +
                              "--set sample.average=160 --max-walltime 0.1 --out " + out)
                   .code;
    const std::filesystem::path file = out + "/" + engine + ".h5";
    shaken::run::Spent before;
    int parts = 1;
    for (; code == 75; ++parts) {
        before = spent_by(checkpoint);
        code = support::shell(command + " --max-walltime 0.1 --resume " + out).code;
    }
    REQUIRE(code == 0);
    REQUIRE(parts > 3);  // so that the last part, of 0.1 s and the time to begin, is less than those before it
    const double elapsed = since(start);
    const shaken::files::Hdf5File written(file, shaken::files::Open::read);
    CHECK(written.read_text("/provenance/parent") == checkpoint);
    CHECK(written.read<std::uint64_t>("/provenance/seed").at(0) == (engine == "md" ? 77u : 78u));
    const double wall = written.read_number_attribute("/run", "wall_seconds"),
                 cpu = written.read_number_attribute("/run", "cpu_seconds");
    CHECK(wall > before.wall);
    CHECK(cpu > before.cpu);
    CHECK(before.wall > 0.1 * (parts - 1));
    CHECK(wall < elapsed);
    CHECK(cpu < elapsed);
}

TEST_CASE("the file of a run that was not resumed has no parent") {
    const support::TemporaryFolder folder;
    const std::string out = (folder / "run").string();
    REQUIRE(
        support::shaken(std::string("-q md ") + support::small_scene + " --set sample.average=1 --out " + out).code ==
        0);
    CHECK(shaken::files::Hdf5File(out + "/md.h5", shaken::files::Open::read).read_text("/provenance/parent").empty());
}
