// SPDX-License-Identifier: MIT
#include "fields/time_series.hpp"

#include <array>

#include "files/errors.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

using fields::TimeSeries;

TEST_CASE("a time series holds a value for each column of a row") {
    TimeSeries series({"energy", "height"});
    series.add(0, 0.0, std::array{1.5, 9.0});
    series.add(1, 0.1, std::array{1.25, 8.5});
    CHECK(series.rows() == 2);
    CHECK(series.value(1, "height") == 8.5);
    CHECK_THROWS_AS(series.value(2, "height"), std::out_of_range);
    CHECK_THROWS_AS(series.value(0, "depth"), std::out_of_range);
    CHECK_THROWS_AS(series.add(2, 0.2, std::array{1.0}), std::invalid_argument);
}

TEST_CASE("a time series is read from the observables of a file, and columns of unequal length are refused") {
    const support::TemporaryFolder folder;
    files::Hdf5File file(folder / "a.h5", files::Open::create);
    file.write<std::int64_t>("/observables/energy/step", std::array<std::int64_t, 2>{0, 1}, {2});
    file.write("/observables/energy/time", std::vector<double>{0.0, 0.1});
    file.write("/observables/energy/value", std::vector<double>{1.5, 1.25});
    file.write("/observables/height/value", std::vector<double>{9.0, 8.5});
    file.write("/observables/mass/value", std::vector<double>{1.0});
    const TimeSeries series = TimeSeries::read(file, {"energy", "height"});
    CHECK(series.rows() == 2);
    CHECK(series.time(1) == 0.1);
    CHECK(series.value(1, "energy") == 1.25);
    CHECK(series.value(0, "height") == 9.0);
    CHECK_THROWS_AS(TimeSeries::read(file, {"energy", "mass"}), files::Damaged);
}
