// SPDX-License-Identifier: MIT
// Stopped, killed and restarted runs end in the same state and the same data as one that was left alone.
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "files/hdf5.hpp"
#include "run/resume.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/command.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

std::string engine_command(const std::string& engine, const std::string& out, int cycles = 12) {
    return engine + " " + support::small_scene + " --set sample.average=" + std::to_string(cycles) + " --out " + out;
}

/// Starts or resumes a run and kills it as soon as it has kept so many more checkpoints; its exit code.
int kill_after(int checkpoints, const std::string& command, const std::string& checkpoint) {
    // A checkpoint is written beside the one before it and takes its name: it is then another file.
    const std::string number = "$(stat -c %i " + checkpoint + " 2> /dev/null)";
    return support::shell("last=" + number + "; " SHAKEN_COMMAND " " + command +
                          " --checkpoint-every 0.01 & for k in $(seq " + std::to_string(checkpoints) +
                          "); do now=$last; until [ \"$now\" != \"$last\" ] || ! kill -0 $!; do sleep 0.005; now=" +
                          number + "; done; last=$now; done; kill -KILL $!; wait $!")
        .code;
}

/// Equal in every dataset; attributes (wall-clock time) may differ.
void check_equal_data(const std::string& one, const std::string& other) {
    const auto result =
        support::shell("/usr/bin/python3 " SHAKEN_SOURCE_DIR "/tests/support/equal_hdf5.py " + one + " " + other);
    INFO(result.text);
    CHECK(result.code == 0);
}

}  // namespace

TEST_CASE("the same seed gives the same bits, another seed does not") {
    const support::TemporaryFolder folder;
    for (const char* name : {"a", "b"})
        REQUIRE(support::shaken(engine_command("md", (folder / name).string())).code == 0);
    check_equal_data((folder / "a/md.h5").string(), (folder / "b/md.h5").string());
    REQUIRE(support::shaken(engine_command("md", (folder / "c").string()) + " --set md.seed=2").code == 0);
    CHECK(support::shell("/usr/bin/python3 " SHAKEN_SOURCE_DIR "/tests/support/equal_hdf5.py " +
                         (folder / "a/md.h5").string() + " " + (folder / "c/md.h5").string())
              .code != 0);
}

TEST_CASE("a run stopped by its time limit resumes to the same data") {
    const std::string engine = GENERATE("md", "continuum");
    const support::TemporaryFolder folder;
    const std::string straight = (folder / "straight").string(), stopped = (folder / "stopped").string();
    REQUIRE(support::shaken(engine_command(engine, straight, 60)).code == 0);
    CHECK(support::shaken(engine_command(engine, stopped, 60) + " --max-walltime 0.001").code == 75);
    CHECK_FALSE(std::filesystem::exists(stopped + "/" + engine + ".h5"));
    CHECK(support::shaken(engine + " --resume " + stopped + " --max-walltime 0.05").code == 75);
    CHECK_FALSE(std::filesystem::exists(stopped + "/" + engine + ".h5"));
    REQUIRE(support::shaken(engine + " --resume " + stopped).code == 0);
    check_equal_data(straight + "/" + engine + ".h5", stopped + "/" + engine + ".h5");
}

TEST_CASE("MD stops when asked within a sample interval, and resumes to the same data") {
    // One interval of two million contacts, of which the time that is allowed is enough for one look.
    const support::TemporaryFolder folder;
    const std::string straight = (folder / "straight").string(), stopped = (folder / "stopped").string();
    const std::string command =
        "md " SHAKEN_SOURCE_DIR
        "/data/scenes/uniform_elastic.toml --set particles.number=1000 --set sample.interval=400 --set "
        "sample.settle=0 --set sample.duration=400 --out ";
    REQUIRE(support::shaken(command + straight).code == 0);
    CHECK(support::shaken(command + stopped + " --max-walltime 0.01").code == 75);
    std::ifstream status(stopped + "/md.status.json");
    CHECK(nlohmann::json::parse(status).at("cycle") == 1.0);  // the start is sampled, the end is not
    REQUIRE(support::shaken("md --resume " + stopped).code == 0);
    check_equal_data(straight + "/md.h5", stopped + "/md.h5");
}

TEST_CASE("a killed run resumes from its last checkpoint to the same data") {
    const std::string engine = GENERATE("md", "continuum");
    const support::TemporaryFolder folder;
    const std::string straight = (folder / "straight").string(), killed = (folder / "killed").string();
    const std::string checkpoint = killed + "/" + engine + ".checkpoint";
    REQUIRE(support::shaken(engine_command(engine, straight, 120)).code == 0);
    // The first checkpoint is the start, the second one somewhere on the way; no run is fast enough to escape.
    CHECK(kill_after(2, engine_command(engine, killed, 120), checkpoint) == 137);
    for (int tries = 0; tries < 3; ++tries) CHECK(kill_after(2, engine + " --resume " + killed, checkpoint) == 137);
    CHECK_FALSE(std::filesystem::exists(killed + "/" + engine + ".h5"));
    REQUIRE(support::shaken(engine + " --resume " + killed).code == 0);
    check_equal_data(straight + "/" + engine + ".h5", killed + "/" + engine + ".h5");
}

namespace {

/// Kills runs of an engine at random times, also while a frame is written, and holds what they leave to their
/// checkpoint: its file must open with every row and frame until then, and a resumed run ends with the same bits.
void kill_at_random(const std::string& engine, int wanted, double longest) {
    const support::TemporaryFolder folder;
    const std::string straight = (folder / "straight").string(), killed = (folder / "killed").string();
    const std::string more = " --set sample.average=60 --set sample.frames=100 --set sample.frame_cycles=60";
    REQUIRE(support::shaken(engine_command(engine, straight) + more).code == 0);
    const shaken::run::EngineFiles files{killed, engine};
    std::mt19937_64 random(29);
    int kills = 0, finished = 0, restored = 0;
    while (kills < wanted || finished == 0) {
        // From the first instants, when nothing is saved yet, to well within the run.
        const double seconds = 0.002 + longest * static_cast<double>(random()) / static_cast<double>(random.max());
        const bool begun = std::filesystem::exists(files.checkpoint());
        const std::string command = begun ? engine + " --resume " + killed : engine_command(engine, killed) + more;
        const std::string limit = kills < wanted ? "timeout -s KILL " + std::to_string(seconds) + " " : "";
        const auto result = support::shell(limit + SHAKEN_COMMAND " " + command + " --checkpoint-every 0.01");
        INFO("kill " << kills << " after " << seconds << " s: " << result.text);
        if (result.code == 0) {
            check_equal_data(straight + "/" + engine + ".h5", killed + "/" + engine + ".h5");
            std::filesystem::remove_all(killed);
            ++finished;
            continue;
        }
        REQUIRE(result.code == 137);
        ++kills;
        if (!std::filesystem::exists(files.checkpoint())) continue;
        const shaken::run::Resumed from = shaken::run::read_checkpoint(files);
        shaken::run::restore_outputs(killed);
        if (from.is_finished) continue;
        const shaken::files::Hdf5File file(files.output(), shaken::files::Open::read);
        const auto reached = static_cast<std::uint64_t>(from.next_sample);
        CHECK(file.shape("/observables/centre_of_mass/value").at(0) == reached);
        const std::uint64_t frames = reached > 200 ? reached - 200 : 0;
        if (frames > 0 && engine == "md") CHECK(file.shape("/particles/all/position/value").at(0) == frames);
        ++restored;
    }
    CHECK(restored > 0);
}

}  // namespace

TEST_CASE("a run killed at random times loses nothing up to its last checkpoint") {
    kill_at_random(GENERATE("md", "continuum"), 6, 0.6);
}

TEST_CASE("a run killed at 200 random times loses nothing up to its last checkpoint", "[slow]") {
    kill_at_random("md", 200, 0.4);
}

TEST_CASE("memory and checkpoint do not grow with the cycles of a run") {
    const support::TemporaryFolder folder;
    // Seconds for the few, ten times as many cycles for the many; the peak is the operating system's. A sanitizer keeps
    // what was freed, and must not here.
    const auto peak_of = [&](const std::string& name, int cycles) {
        const auto result = support::shell(
            "ASAN_OPTIONS=quarantine_size_mb=1 /usr/bin/python3 -c 'import resource, subprocess, sys; "
            "subprocess.run(sys.argv[1:], check=True); "
            "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)' " SHAKEN_COMMAND " -q " +
            engine_command("md", (folder / name).string(), cycles) +
            " --set particles.number=1 --set sample.map_bin=0 --set sample.settle=0 > " + (folder / "said").string() +
            " && tail -n 1 " + (folder / "said").string());
        INFO(result.text);
        REQUIRE(result.code == 0);
        return std::stod(result.text);
    };
    const double few = peak_of("few", 200), many = peak_of("many", 4000);
    CHECK(many < 1.5 * few);
    const auto size = [&](const std::string& name) {
        return static_cast<double>(std::filesystem::file_size(folder / (name + "/md.checkpoint")));
    };
    CHECK(size("many") < 1.5 * size("few"));
}

TEST_CASE("what is measured, how often and what is saved leave the state's bits alone") {
    const support::TemporaryFolder folder;
    const auto state = [&](const std::string& name, const std::string& more) {
        const auto result = support::shaken(engine_command("md", (folder / name).string()) + " " + more);
        INFO(result.text);
        REQUIRE(result.code == 0);
        const std::size_t at = result.text.rfind("state ");
        REQUIRE(at != std::string::npos);
        return result.text.substr(at + 6, 16);
    };
    const std::string usual = state("usual", "");
    CHECK(state("rare", "--set sample.phases=20 --set sample.frames=0") == usual);
    CHECK(state("often", "--set sample.phases=400 --set sample.frames=400 --set sample.bin=0.25") == usual);
    CHECK(state("saved", "--checkpoint-every 0.01") == usual);
    CHECK(state("other", "--set md.seed=2") != usual);
}

TEST_CASE("TERM stops with a checkpoint and 75, and the message says how to go on") {
    const support::TemporaryFolder folder;
    const std::string out = (folder / "a").string();
    const auto result = support::shell("timeout --preserve-status -s TERM 0.3 " SHAKEN_COMMAND " " +
                                       engine_command("md", out) + " --set sample.average=2000");
    CHECK(result.code == 75);
    CHECK_THAT(result.text, Contains("go on with: shaken md --resume"));
    CHECK(std::filesystem::exists(out + "/md.checkpoint"));
}

TEST_CASE("a damaged checkpoint is refused with its reason, and a missing one too") {
    const support::TemporaryFolder folder;
    const std::string out = (folder / "a").string();
    REQUIRE(support::shaken(engine_command("md", out) + " --max-walltime 0.001").code == 75);
    std::filesystem::resize_file(out + "/md.checkpoint", std::filesystem::file_size(out + "/md.checkpoint") / 2);
    const auto result = support::shaken("md --resume " + out);
    CHECK(result.code == 65);
    CHECK_THAT(result.text, Contains("damaged checkpoint"));
    CHECK(support::shaken("continuum --resume " + out).code == 66);
    CHECK(support::shaken("md --resume " + (folder / "nowhere").string()).code == 66);
}

TEST_CASE("a resumed run refuses a scene that was edited meanwhile") {
    const support::TemporaryFolder folder;
    const std::string out = (folder / "a").string();
    REQUIRE(support::shaken(engine_command("md", out) + " --max-walltime 0.001").code == 75);
    REQUIRE(support::shell("sed -i 's/^number = 200/number = 150/' " + out + "/scene.toml").code == 0);
    const auto result = support::shaken("md --resume " + out);
    CHECK(result.code == 65);
    CHECK_THAT(result.text, Contains("scene.toml:") && Contains("number = 200"));
}

TEST_CASE("a finished run whose output was damaged says so: its checkpoint does not have what was in it") {
    const support::TemporaryFolder folder;
    const std::string out = (folder / "a").string();
    REQUIRE(support::shaken(engine_command("continuum", out)).code == 0);
    CHECK(support::shaken("continuum --resume " + out).code == 0);
    std::filesystem::resize_file(out + "/continuum.h5", 5000);
    const auto result = support::shaken("continuum --resume " + out);
    CHECK(result.code == 65);
    CHECK_THAT(result.text, Contains("continuum.h5: is not readable") && Contains("begin it anew"));
}
