// SPDX-License-Identifier: MIT
// The command from outside: what it says, what it leaves, how it ends.
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/catch.hpp"
#include "tests/support/command.hpp"
#include "tests/support/temporary_folder.hpp"

using support::shaken;
using support::small_scene;

TEST_CASE("usage errors end with 2 and name what is meant") {
    CHECK(shaken("").code == 2);
    CHECK_THAT(shaken("comapre x").text, Contains("unknown command 'comapre'") && Contains("did you mean compare?"));
    CHECK(shaken("comapre x").code == 2);
    CHECK(shaken("md").code == 2);
    CHECK(shaken(std::string("md ") + small_scene).code == 2);
    CHECK(shaken(std::string("md ") + small_scene + " --out x --max-walltime never").code == 2);
    CHECK(shaken("scene").code == 2);
    CHECK(shaken("--help").code == 0);
}

TEST_CASE("the version names commit, compiler, flags and libraries") {
    const auto result = shaken("--version");
    CHECK(result.code == 0);
    CHECK_THAT(result.text,
               Contains("shaken 0") && (Contains("GNU") || Contains("Clang")) && Contains("-O") && Contains("HDF5"));
}

TEST_CASE("a missing scene ends with 66, a bad one with 65") {
    CHECK(shaken("scene no_such.toml").code == 66);
    const auto bad = shaken(std::string("scene ") + small_scene + " --set particles.restitution=1.3");
    CHECK(bad.code == 65);
    CHECK_THAT(bad.text, Contains("particles.restitution = 1.3 is outside [0, 1]"));
}

TEST_CASE("the resolved scene is a scene, and the keys are listed with units and ranges") {
    const support::TemporaryFolder folder;
    const std::string first = (folder / "a.toml").string();
    CHECK(shaken(std::string("scene ") + small_scene + " > " + first).code == 0);
    CHECK(shaken("scene " + first).text == support::content_of(first));
    for (const char* given : {"frequency = 0.15", "number = 200", "ceiling = 60.0", "phases = 100", "settle = 2",
                              "average = 4", "map_bin = 2.0", "lid = 40.0"})
        CHECK_THAT(support::content_of(first), Contains(std::string("\n") + given + "\n"));
    CHECK_THAT(shaken("scene --keys").text,
               Contains("acceleration") && Contains("in sqrt(g/sigma)") && Contains("closure: jenkins_richman"));
}

TEST_CASE("a name that no table has is refused with its place before anything runs long") {
    const support::TemporaryFolder folder;
    const auto result =
        shaken(std::string("continuum ") + small_scene + " --set continuum.flux=hlc --out " + (folder / "a").string());
    CHECK(result.code == 65);
    CHECK_THAT(result.text, Contains("continuum.flux = \"hlc\" is unknown") && Contains("did you mean"));
}

TEST_CASE("what a run leaves names what ran") {
    const support::TemporaryFolder folder;
    const std::string out = (folder / "run").string();
    const std::string settings = std::string(small_scene) + " --set continuum.spacing=0.3 --set continuum.scheme=ftcs" +
                                 " --set sample.settle=0 --set sample.average=1";
    const auto refused = shaken("continuum " + settings + " --out " + out);
    CHECK(refused.code == 65);
    CHECK_THAT(refused.text, Contains("it can run \"jenkins_richman_dense\""));

    const std::string named = settings + " --set continuum.closure=jenkins_richman_dense";
    const auto run = shaken("run " + named + " --out " + out);
    INFO(run.text);
    REQUIRE(run.code == 0);
    const std::string said = support::content_of(out + "/scene.toml");
    CHECK(shaken("scene " + named).text == said);
    CHECK_THAT(said, Contains("closure = \"jenkins_richman_dense\"") && Contains("floor_density = 0.001") &&
                         Contains("dimension = \"1\"") && !Contains("limiter") && !Contains("cfl"));
    for (const char* file : {"md.h5", "continuum.h5", "compare.h5"}) {
        const auto stored = support::shell(
            "/usr/bin/python3 -c 'import h5py, sys; print(h5py.File(sys.argv[1])"
            "[\"provenance/scene\"][()].decode(), end=\"\")' " +
            out + "/" + file);
        INFO(file);
        CHECK(stored.text == said);
    }
}

TEST_CASE("folders that cannot take a run end with 73 and lose nothing") {
    const support::TemporaryFolder folder;
    std::filesystem::create_directory(folder / "full");
    std::ofstream(folder / "full/md.h5") << "precious";
    const std::string command = std::string("md ") + small_scene + " --out " + (folder / "full").string();
    CHECK(shaken(command).code == 73);
    CHECK(support::content_of((folder / "full/md.h5").string()) == "precious");
    CHECK(shaken(std::string("md ") + small_scene + " --out /proc/none").code == 73);
}

TEST_CASE("a scene that cannot run removes nothing of the run it would replace") {
    const support::TemporaryFolder folder;
    const std::string out = (folder / "a").string();
    REQUIRE(shaken(std::string("md ") + small_scene + " --out " + out).code == 0);
    const std::string before = support::content_of(out + "/md.h5");
    CHECK(shaken(std::string("md ") + small_scene + " --overwrite --set initial.file=/no/such.h5 --out " + out).code ==
          66);
    CHECK(shaken(std::string("run ") + small_scene + " --overwrite --set continuum.scheme=foo --out " + out).code ==
          65);
    CHECK(support::content_of(out + "/md.h5") == before);
}

TEST_CASE("a run takes no folder from another that is at work there") {
    const support::TemporaryFolder folder;
    const std::string out = (folder / "a").string();
    const auto result = support::shell(
        std::string(SHAKEN_COMMAND) + " md " + small_scene + " --set sample.average=2000 -q --out " + out +
        " & until [ -e " + out + "/md.checkpoint ]; do sleep 0.02; done; " + SHAKEN_COMMAND + " continuum " +
        small_scene + " --overwrite --out " + out + "; code=$?; kill $!; wait $!; exit $code");
    CHECK(result.code == 73);
    CHECK_THAT(result.text, Contains("another run of md is at work there"));
}

TEST_CASE("a file past the size limit is a failed write, and what stood there still stands") {
    const support::TemporaryFolder folder;
    const std::string out = (folder / "a").string();
    REQUIRE(shaken(std::string("run ") + small_scene + " --out " + out).code == 0);
    const std::string before = support::content_of(out + "/compare.h5");
    CHECK(support::shell("ulimit -f 100; " SHAKEN_COMMAND " compare " + out).code == 74);
    CHECK(support::content_of(out + "/compare.h5") == before);
    CHECK(support::shell("ulimit -f 100; " SHAKEN_COMMAND " md " + std::string(small_scene) + " --out " +
                         (folder / "b").string())
              .code == 74);
}

TEST_CASE("results that cannot be said are a failed write") {
    CHECK(support::shell(SHAKEN_COMMAND " scene --keys > /dev/full").code == 74);
}

TEST_CASE("comparing and reporting need both engines' files") {
    const support::TemporaryFolder folder;
    CHECK(shaken("compare " + folder.path().string()).code == 66);
    CHECK(shaken("report " + folder.path().string()).code == 66);
    std::ofstream(folder / "md.h5") << "no HDF5";
    std::ofstream(folder / "continuum.h5") << "no HDF5";
    CHECK(shaken("compare " + folder.path().string()).code == 65);
}

TEST_CASE("one command runs both engines, compares and reports") {
    const support::TemporaryFolder folder;
    const std::string out = (folder / "run").string();
    const auto start = std::chrono::steady_clock::now();
    const auto result =
        support::shell("OMP_NUM_THREADS=1 " SHAKEN_COMMAND " run " + std::string(small_scene) + " --out " + out);
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    INFO(result.text);
    REQUIRE(result.code == 0);
    for (const char* name :
         {"scene.toml", "md.h5", "continuum.h5", "continuum.xdmf", "compare.h5", "summary.json", "report.html"}) {
        INFO(name);
        CHECK(std::filesystem::exists(std::filesystem::path(out) / name));
    }
    const auto summary = nlohmann::json::parse(support::content_of(out + "/summary.json"));
    for (const char* engine : {"md", "continuum"}) {
        CHECK(summary.at(engine).at("zcm").size() == 20);
        for (const char* key : {"formation_phase", "leaving_phase", "mean_speed"})
            CHECK(summary.at(engine).at("shock").contains(key));
        const double cpu = summary.at(engine).at("cpu_seconds"), wall = summary.at(engine).at("wall_seconds");
        CHECK(cpu > 1e-3);     // 200 particles, or 80 cells, over six cycles
        CHECK(cpu < elapsed);  // of one thread
        CHECK(wall < elapsed);
    }
    CHECK(summary.at("md").at("collisions_per_particle_per_cycle").get<double>() > 1.0);
    CHECK(summary.at("continuum").at("steps_per_cycle").get<double>() > 10.0);
    CHECK(summary.at("zcm_rms_percent").is_number());
    CHECK(summary.contains("zcm_rms_percent_half_diameter"));
    CHECK(summary.contains("shock_location_rms"));

    // Self-contained: nothing is loaded from elsewhere.
    const std::string report = support::content_of(out + "/report.html");
    CHECK_THAT(report, Contains("<img") && !Contains("src=\"http") && !Contains("href=\"http"));

    const auto opened = support::shell("/usr/bin/python3 " SHAKEN_SOURCE_DIR "/tests/app/open_outputs.py " + out);
    INFO(opened.text);
    CHECK(opened.code == 0);

    SECTION("a second run into the folder is refused, and allowed with --overwrite") {
        CHECK(shaken(std::string("run ") + small_scene + " --out " + out).code == 73);
        CHECK(shaken("compare " + out).code == 0);
    }
}

TEST_CASE("what one engine would refuse ends the run before the other begins") {
    const support::TemporaryFolder folder;
    const auto result =
        shaken(std::string("run ") + small_scene + " --set continuum.flux=hlc --out " + (folder / "run").string());
    CHECK(result.code == 65);
    CHECK_THAT(result.text, Contains("continuum.flux = \"hlc\" is unknown"));
}

TEST_CASE("runs with other seeds are averaged, runs of another layer refused") {
    const support::TemporaryFolder folder;
    const auto at = [&](const std::string& name) { return (folder / name).string(); };
    const auto ran = [&](const std::string& engine, const std::string& name, const std::string& set) {
        return shaken(engine + " " + small_scene + " -q --out " + at(name) + set).code == 0;
    };
    REQUIRE(ran("md", "a", ""));
    REQUIRE(ran("md", "b", " --set md.seed=2 --set initial.seed=2"));
    REQUIRE(ran("md", "c", " --set particles.restitution=0.95"));
    REQUIRE(ran("continuum", "h", " --set continuum.closure=garzo_dufty"));
    const std::string h = " --continuum " + at("h");
    const auto compared = [&](const std::string& name, const std::string& runs) {
        const auto result = shaken("compare " + at(name) + runs + h);
        INFO(result.text);
        REQUIRE(result.code == 0);
        return nlohmann::json::parse(support::content_of(at(name) + "/summary.json"));
    };
    const auto a = compared("of_a", " --md " + at("a")), b = compared("of_b", " --md " + at("b")),
               both = compared("of_both", " --md " + at("a") + " --md " + at("b"));
    CHECK(both["runs"]["md"].size() == 2);
    for (std::size_t k = 0; k < 20; ++k) {
        const double mean = 0.5 * (a["md"]["zcm"][k].get<double>() + b["md"]["zcm"][k].get<double>());
        CHECK(both["md"]["zcm"][k].get<double>() == Approx(mean).epsilon(1e-12));  // round-off
    }
    const auto other = shaken("compare " + at("d") + " --md " + at("a") + " --md " + at("c") + h);
    CHECK(other.code == 65);
    CHECK_THAT(other.text, Contains("runs of different scenes"));
    REQUIRE(ran("md", "long", " --set md.seed=3 --set sample.average=20"));
    const auto uneven = shaken("compare " + at("d") + " --md " + at("a") + " --md " + at("long") + h);
    CHECK(uneven.code == 65);
    CHECK_THAT(uneven.text, Contains("long/md.h5: runs cannot be averaged"));
    CHECK_FALSE(std::filesystem::exists(folder / "d"));
}
