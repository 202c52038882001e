// SPDX-License-Identifier: MIT
// What a stream holds, in the file that is made from it.
#include "run/output.hpp"

#include <cmath>

#include "files/errors.hpp"
#include "files/record_log.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

using run::Stream;

namespace {

class Streamed {
  public:
    void add(Stream kind, const std::vector<double>& values) { log_.append(static_cast<std::uint64_t>(kind), values); }
    /// The file made of all that was added.
    files::Hdf5File written(const run::Streams& streams) {
        files::Hdf5File file(folder_ / "a.h5", files::Open::create);
        run::write_streams(file, {folder_ / "a.h5", folder_ / "a.stream", log_.sync(), "", "", {}}, streams);
        return file;
    }

  private:
    support::TemporaryFolder folder_;
    files::RecordLog log_{folder_ / "a.stream", 0};
};

const auto no_frame = [](std::span<const double>) {};
const std::vector<run::ColumnName> two{{"height", "sigma"}, {"energy", "m g sigma"}};

/// 20 phases, one settling cycle, two averaged.
scene::Schedule schedule() {
    scene::Scene scene;
    scene.sample.phases = 20;
    scene.sample.settle = 1;
    scene.sample.average = 2;
    return scene::Schedule(scene);
}

}  // namespace

TEST_CASE("rows become observables with their units, of one step and time") {
    Streamed streamed;
    constexpr int rows = 70'000;  // more than a piece
    for (int row = 0; row < rows; ++row) streamed.add(Stream::row, {5.0 + row, 0.5 * row, 1.0 * row, -2.0 * row});
    const files::Hdf5File file = streamed.written({two, no_frame});
    const auto energy = file.read<double>("/observables/energy/value");
    const auto step = file.read<std::int64_t>("/observables/energy/step");
    REQUIRE(energy.size() == rows);
    CHECK(step.front() == 5);
    CHECK(step.back() == 5 + rows - 1);
    CHECK(file.read<double>("/observables/height/time").back() == 0.5 * (rows - 1));
    for (const int row : {0, 1, 65'535, 65'536, rows - 1}) CHECK(energy[static_cast<std::size_t>(row)] == -2.0 * row);
    CHECK(file.read_text_attribute("/observables/energy/value", "unit") == "m g sigma");
    CHECK_FALSE(file.has("/height_maps"));
    CHECK_FALSE(file.has("/profiles"));
}

TEST_CASE("heights stand at their cycle and phase, and are unknown where there was no sample") {
    Streamed streamed;
    streamed.add(Stream::height, {0.0, 3.0, 7.5});  // a start at ft = 0.15
    streamed.add(Stream::height, {0.0, 4.0, 7.25});
    const files::Hdf5File file = streamed.written({two, no_frame, schedule()});
    CHECK(file.shape("/profiles/centre_of_mass") == files::Shape{2, 20});
    const auto heights = file.read<double>("/profiles/centre_of_mass");
    CHECK(heights[3] == 7.5);
    CHECK(heights[4] == 7.25);
    CHECK(std::count_if(heights.begin(), heights.end(), [](double z) { return std::isnan(z); }) == 38);
}

TEST_CASE("maps and frames come out in their order") {
    Streamed streamed;
    streamed.add(Stream::map, {0.0, 0.25, 1, 2, 3, 4, 5, 6});
    streamed.add(Stream::frame, {4.0});
    streamed.add(Stream::map, {1.0, 0.75, 6, 5, 4, 3, 2, 1});
    streamed.add(Stream::frame, {9.0, 9.5});
    std::vector<double> firsts;
    const auto frame = [&](std::span<const double> record) { firsts.push_back(record[0]); };
    const files::Hdf5File file = streamed.written({two, frame, schedule(), {3, 2, 12.0, 10.0}});
    CHECK(firsts == std::vector<double>{4.0, 9.0});
    const fields::HeightMaps maps = fields::HeightMaps::read(file, "/height_maps");
    REQUIRE(maps.rows() == 2);
    CHECK(maps.cycle(1) == 1);
    CHECK(maps.phase(1) == 0.75);
    CHECK(maps.row(1) == std::vector<double>{6, 5, 4, 3, 2, 1});
    CHECK(maps.grid() == fields::HorizontalGrid{3, 2, 12.0, 10.0});
}

TEST_CASE("records that are not as wide as this program's are refused") {
    Streamed rows, maps;
    rows.add(Stream::row, {0.0, 0.0, 1.0});
    CHECK_THROWS_AS(rows.written({two, no_frame}), files::Damaged);
    maps.add(Stream::map, {0.0, 0.0, 1.0});
    CHECK_THROWS_AS(maps.written({two, no_frame, schedule(), {3, 2, 12.0, 10.0}}), files::Damaged);
}
