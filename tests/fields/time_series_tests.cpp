// SPDX-License-Identifier: MIT
#include "fields/time_series.hpp"

#include <array>

#include "files/errors.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

using fields::TimeSeries;

TEST_CASE("a time series goes through checkpoint and file unchanged") {
    const support::TemporaryFolder folder;
    TimeSeries series({"energy", "height"});
    series.add(0, 0.0, std::array{1.5, 9.0});
    series.add(1, 0.1, std::array{1.25, 8.5});
    files::CheckpointWriter out;
    series.save(out, "series/");
    out.commit(folder / "a");
    TimeSeries again({"energy", "height"});
    again.restore(files::CheckpointReader(folder / "a"), "series/");
    CHECK(again.rows() == 2);
    CHECK(again.value(1, "height") == 8.5);
    CHECK_THROWS_AS(again.value(2, "height"), std::out_of_range);
    CHECK_THROWS_AS(again.value(0, "depth"), std::out_of_range);
    CHECK_THROWS_AS(again.add(2, 0.2, std::array{1.0}), std::invalid_argument);

    TimeSeries wider({"energy", "height", "mass"});
    CHECK_THROWS_AS(wider.restore(files::CheckpointReader(folder / "a"), "series/"), files::Damaged);

    files::Hdf5File file(folder / "a.h5", files::Open::create);
    again.write(file);
    CHECK(file.read<double>("/observables/energy/value") == std::vector<double>{1.5, 1.25});
    CHECK(file.read<std::int64_t>("/observables/height/step") == std::vector<std::int64_t>{0, 1});
    CHECK(file.read<double>("/observables/height/time") == std::vector<double>{0.0, 0.1});
}
