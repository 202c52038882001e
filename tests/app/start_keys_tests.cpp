// SPDX-License-Identifier: MIT
// Keys that cannot act on the start that a scene names: refused, or said in one line.
#include "app/start_keys.hpp"

#include "compare/scenes.hpp"
#include "scene/errors.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/command.hpp"
#include "tests/support/temporary_folder.hpp"

using shaken::run::Notes;

namespace {

shaken::scene::Scene with(const std::vector<std::string>& changes) {
    return shaken::compare::read_scene(support::small_scene, changes);
}

Notes of_continuum(const std::vector<std::string>& changes, bool beside_md = false) {
    return shaken::app::notes_of_continuum_start(with(changes), beside_md);
}

}  // namespace

TEST_CASE("the numbers of a wave without a wave are said to have no part, whichever of them is given") {
    for (const char* key : {"initial.wave_x=2", "initial.wave_x=0", "initial.wave_y=3"}) {
        for (const bool beside_md : {false, true}) {
            const Notes notes = of_continuum({key}, beside_md);
            INFO(key);
            REQUIRE(notes.size() == 1);
            CHECK_THAT(notes[0], Contains("have no part") && Contains("initial.wave is 0"));
        }
        CHECK(of_continuum({key, "initial.wave=0.1"}).empty());
    }
    CHECK_THAT(of_continuum({"initial.wave_x=2"})[0], Contains("initial.wave_x = 2 and initial.wave_y = 0"));
    CHECK(of_continuum({}).empty());
    CHECK(of_continuum({"initial.wave_x=1", "initial.wave_y=0"}).empty());  // as they are by default
}

TEST_CASE("a seed is said to have no part in a continuum that starts without noise") {
    const std::string seed = "initial.seed=5";
    for (const auto& changes :
         {std::vector{seed}, std::vector{seed, std::string("initial.wave=0.1")},
          std::vector{seed, std::string("initial.noise=0.01"), std::string("continuum.dimension=1")}}) {
        const Notes notes = of_continuum(changes);
        INFO(changes.back());
        REQUIRE(notes.size() == 1);
        CHECK_THAT(notes[0], Contains("initial.seed = 5 has no part"));
        CHECK(of_continuum(changes, true).empty());  // the MD starts from it
    }
    CHECK(of_continuum({seed, "initial.noise=0.01", "continuum.dimension=3"}).empty());
}

TEST_CASE("seeds beside a start from a file are said to have no part in the MD, a phase without a file is refused") {
    CHECK(shaken::app::notes_of_start(with({"md.seed=2"})).empty());
    for (const char* seed : {"md.seed=2", "initial.seed=2"}) {
        const Notes notes = shaken::app::notes_of_start(with({seed, "initial.file=\"earlier.h5\""}));
        REQUIRE(notes.size() == 1);
        CHECK_THAT(notes[0], Contains("md.seed and initial.seed have no part"));
    }
    CHECK_THROWS_WITH(shaken::app::refuse_phase_without_file(with({"initial.phase=0.35"})),
                      Contains("initial.phase = 0.35 needs initial.file"));
    CHECK_NOTHROW(shaken::app::refuse_phase_without_file(with({"initial.phase=0.35", "initial.file=\"earlier.h5\""})));
}

TEST_CASE("both commands that run a continuum say it") {
    const support::TemporaryFolder folder;
    const std::string changes =
        std::string(support::small_scene) +
        " --set initial.wave_x=2 --set initial.seed=5 --set sample.settle=0 --set sample.average=1 --out ";
    const auto alone = support::shaken("-q continuum " + changes + (folder / "alone").string());
    CHECK(alone.code == 0);
    CHECK_THAT(alone.text, Contains("note: initial.wave_x = 2") && Contains("note: initial.seed = 5"));
    const auto both = support::shaken("-q run --max-walltime 0.001 " + changes + (folder / "both").string());
    CHECK(both.code == 75);  // before the engines begin
    CHECK_THAT(both.text, Contains("note: initial.wave_x = 2") && !Contains("note: initial.seed"));
}
