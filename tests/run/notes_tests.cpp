// SPDX-License-Identifier: MIT
// What a continuum run says of itself, from the scene to the terminal and the file.
#include "run/notes.hpp"

#include "files/hdf5.hpp"
#include "compare/scenes.hpp"
#include "scene/read_scene.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/command.hpp"
#include "tests/support/temporary_folder.hpp"

using shaken::run::Notes;

namespace {

const std::string stripes = SHAKEN_SOURCE_DIR "/data/scenes/ch5_stripes.toml";

Notes notes_with(std::vector<std::string> changes) {
    changes.insert(changes.begin(), {"particles.number=2400", "box.x=40", "box.y=10"});
    return shaken::run::notes_of_scene(shaken::compare::read_scene(stripes, changes));
}

}  // namespace

TEST_CASE("a continuum that takes one column where waves fit says so, with the key that lets them grow") {
    // H = 5.4, f* = 0.4: lambda = H (1 + 1.1 f*^-1.32).
    const Notes notes = notes_with({"initial.noise=0", "plate.frequency_star=0.4", "continuum.dimension=auto"});
    REQUIRE(notes.size() == 1);
    CHECK_THAT(notes[0], Contains("Waves some 25.3 sigma long fit in the box of 40 x 10") && Contains("one column") &&
                             Contains("continuum.dimension") && Contains("initial.noise"));
    CHECK(notes_with({"initial.noise=0.01", "continuum.dimension=auto"}).empty());
    CHECK(notes_with({"initial.noise=0", "plate.frequency_star=0.4", "continuum.dimension=1"}) == notes);
    const Notes equal = notes_with({"initial.noise=0", "continuum.dimension=2"});
    REQUIRE(equal.size() == 1);
    CHECK_THAT(equal[0], Contains("All columns start equal"));
    // 8 wide is 0.33 of the wave: none fits.
    CHECK(notes_with({"initial.noise=0", "continuum.dimension=auto", "particles.number=384", "box.x=8", "box.y=8"})
              .empty());
}

TEST_CASE("what a continuum run says of its scene stands on the terminal and in its file") {
    const std::string friction = "particles.friction={law=\"walton\",beta0=0.35,mu=0.5}";
    const Notes notes = notes_with({"initial.noise=0.01", "continuum.dimension=auto", friction});
    REQUIRE(notes.size() == 1);
    CHECK_THAT(notes[0], Contains("no friction") && Contains("particles.friction"));

    const support::TemporaryFolder folder;
    const auto run = [&](const std::string& more, const std::string& to) {
        const auto result = support::shaken(
            "continuum -q " + stripes +
            " --set continuum.dimension=auto --set sample.settle=0 --set sample.average=1 --set sample.phases=20" +
            more + " --out " + (folder / to).string());
        REQUIRE(result.code == 0);
        const shaken::files::Hdf5File file(folder / to / "continuum.h5", shaken::files::Open::read);
        return std::pair(result.text, shaken::run::parted(file.read_text("/run/notes")));
    };
    const auto [terminal, in_file] = run(" --set '" + friction + "'", "friction");
    CHECK_THAT(terminal, Contains("note: " + notes[0]));
    REQUIRE(in_file.size() >= 2);
    CHECK(in_file[0] == notes[0]);
    // "auto" is resolved before the run begins, and the run says what came of it.
    CHECK_THAT(in_file[1], Contains("fit in the box of 42 x 42") && Contains("takes one column"));
    CHECK_THAT(terminal, Contains("note: " + in_file[1]));
    for (const std::string& note : run("", "smooth").second) CHECK_THAT(note, !Contains("friction"));
}

TEST_CASE("a run whose gas reaches the upper end says so, one whose gas does not is silent") {
    const support::TemporaryFolder folder;
    const auto said = [&](const std::string& lid) {
        const auto result = support::shaken("continuum -q " SHAKEN_SOURCE_DIR
                                            "/data/scenes/ch4_shock.toml --set continuum.spacing=0.5 "
                                            "--set sample.settle=8 --set sample.average=4 --set sample.phases=20 "
                                            "--set sample.frames=0 --set continuum.lid=" +
                                            lid + " --out " + (folder / lid).string());
        REQUIRE(result.code == 0);
        const shaken::files::Hdf5File file(folder / lid / "continuum.h5", shaken::files::Open::read);
        const std::string notes = file.read_text("/run/notes");
        CHECK((result.text.find("upper end") == std::string::npos) == (notes.find("upper end") == std::string::npos));
        return notes;
    };
    // 2e-3 and 1e-5 of the layer's weight.
    CHECK_THAT(said("80"),
               Contains("The upper end at continuum.lid = 80 bears 0.002") && Contains("raise continuum.lid"));
    CHECK_THAT(said("120"), !Contains("upper end"));
}
