// SPDX-License-Identifier: MIT
#include "files/errors.hpp"
#include "md/errors.hpp"
#include "md/h5md.hpp"
#include "small_systems.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

TEST_CASE("what is written as H5MD is read back, frame by frame") {
    const auto scene = small::layer();
    const md::Box box{scene.box.x, scene.box.y, scene.box.ceiling, false, scene.motion};
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "md.h5";
    md::Simulation simulation(scene);
    std::vector<md::Snapshot> shots;
    {
        md::H5mdWriter writer(path, box, {"[scene]\n", 1, ""});
        for (int frame = 0; frame < 3; ++frame) {
            simulation.advance_to(0, 0.1 * frame);
            shots.push_back(simulation.snapshot());
            writer.append(shots.back(), frame * 10, 0.1 * frame);
            writer.flush();
        }
        writer.close();
    }
    const md::H5mdFrames read = md::read_h5md(path);
    CHECK(read.step == std::vector<std::int64_t>{0, 10, 20});
    CHECK(read.time == std::vector<double>{0.0, 0.1, 0.2});
    REQUIRE(read.frames.size() == 3);
    for (std::size_t frame = 0; frame < 3; ++frame) {
        CHECK(read.frames[frame].position == shots[frame].position);
        CHECK(read.frames[frame].velocity == shots[frame].velocity);
    }
    const files::Hdf5File file(path, files::Open::read);
    CHECK(file.read_text_attribute("/h5md/creator", "name") == "shaken");
    CHECK(file.shape("/particles/all/box/edges/value") == files::Shape{3, 3, 3});
    CHECK(file.read<double>("/particles/all/box/edges/time") == read.time);
    CHECK(file.read<std::int64_t>("/particles/all/velocity/step") == read.step);
    CHECK(file.has("/provenance"));
}

TEST_CASE("a run starts from the last frame of the file its scene names") {
    auto scene = small::layer();
    const md::Box box{scene.box.x, scene.box.y, scene.box.ceiling, false, scene.motion};
    const support::TemporaryFolder folder;
    md::Simulation first(scene);
    first.advance_to(1, 0.0);
    scene.initial.file = folder.path() / "start.h5";
    md::H5mdWriter writer(scene.initial.file, box, {"[scene]\n", 1, ""});
    writer.append(md::Simulation(small::layer()).snapshot(), 0, 0.0);
    writer.append(first.snapshot(), 1, first.plate_period());
    writer.close();
    const md::Simulation second(scene);
    CHECK(second.snapshot().position == first.snapshot().position);
    // The frame takes the mean velocity out and puts it back: round-off.
    for (std::size_t i = 0; i < 150; ++i)
        CHECK(second.snapshot().velocity[i][2] == Approx(first.snapshot().velocity[i][2]).margin(1e-14));
    scene.number_of_particles = 149;
    CHECK_THROWS_AS(md::Simulation(scene), md::CannotSetUp);
}

TEST_CASE("a file without particles is refused") {
    const support::TemporaryFolder folder;
    CHECK_THROWS_AS(md::read_h5md(folder.path() / "absent.h5"), files::NoInput);
    files::Hdf5File(folder.path() / "empty.h5", files::Open::create).close();
    CHECK_THROWS_AS(md::read_h5md(folder.path() / "empty.h5"), files::Damaged);
}
