// SPDX-License-Identifier: MIT
// Maps of z_cm(x, y): mass and moment go where they belong, whatever the cells and wherever the positions were wrapped.
#include "fields/height_maps.hpp"

#include <cmath>
#include <numeric>

#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;
using fields::HeightMaps;

TEST_CASE("a point counts in the bin that holds it, on whichever copy of the box it lies") {
    HeightMaps maps({4, 2, 8.0, 4.0});
    maps.begin(3, 0.25);
    maps.add_point(1.0, 1.0, 1.0, 5.0);
    maps.add_point(9.5, -3.0, 3.0, 7.0);  // (1.5, 1.0)
    maps.add_point(7.9, 3.9, 1.0, 2.0);
    maps.end();
    const auto row = maps.row(0);
    CHECK(row[0] == Approx((5.0 + 21.0) / 4.0).epsilon(1e-15));
    CHECK(row[7] == 2.0);
    CHECK(row[3] == Approx(0.5 * (6.5 + 2.0)).epsilon(1e-15));  // empty: the mean of the filled bins
    CHECK(maps.cycle(0) == 3);
    CHECK(maps.phase(0) == 0.25);
}

TEST_CASE("rectangles are parted by area, also across the periodic edge and from finer and coarser cells") {
    const auto map_of = [](std::int64_t cells) {
        HeightMaps maps({4, 1, 4.0, 1.0});
        maps.begin(0, 0.0);
        const double side = 4.0 / static_cast<double>(cells);
        for (std::int64_t i = 0; i < cells; ++i) {
            const double middle = side * (static_cast<double>(i) + 0.5);
            maps.add_rectangle(side * static_cast<double>(i), 0.0, side, 1.0, side, middle);
        }
        maps.end();
        return maps.row(0);
    };
    // Height = x: a bin of whole cells has its own middle, to round-off; cells of 4/3 share theirs between two bins.
    for (std::size_t bin = 0; bin < 4; ++bin) {
        CHECK(map_of(4)[bin] == Approx(static_cast<double>(bin) + 0.5).epsilon(1e-14));
        CHECK(map_of(40)[bin] == Approx(static_cast<double>(bin) + 0.5).epsilon(1e-14));
    }
    CHECK(map_of(3)[0] == Approx(2.0 / 3.0).epsilon(1e-14));
    CHECK(map_of(3)[1] == Approx((2.0 / 3.0 + 2.0 * 2.0) / 3.0).epsilon(1e-14));

    HeightMaps across({4, 1, 4.0, 1.0});
    across.begin(0, 0.0);
    across.add_rectangle(3.5, 0.0, 1.0, 1.0, 1.0, 8.0);
    across.end();
    CHECK(across.row(0)[3] == Approx(8.0));
    CHECK(across.row(0)[0] == Approx(8.0));
}

TEST_CASE("maps come back from a file as they were written") {
    const support::TemporaryFolder folder;
    HeightMaps maps({3, 2, 6.0, 4.0});
    for (int cycle = 0; cycle < 3; ++cycle) {
        maps.begin(cycle, 0.25 * cycle);
        for (int i = 0; i < 6; ++i) maps.add_point(2.0 * (i % 3), 2.0 * (i / 3), 1.0, cycle + 0.1 * i);
        maps.end();
    }
    {
        files::Hdf5File file(folder.path() / "maps.h5", files::Open::create);
        maps.write(file, "/height_maps");
        file.close();
    }
    const files::Hdf5File file(folder.path() / "maps.h5", files::Open::read);
    const HeightMaps read = HeightMaps::read(file, "/height_maps");
    REQUIRE(read.rows() == 3);
    CHECK(read.grid() == maps.grid());
    for (std::size_t r = 0; r < 3; ++r) CHECK(read.row(r) == maps.row(r));
    CHECK(read.rows_at(0.25, 0) == std::vector<std::size_t>{1});
}
