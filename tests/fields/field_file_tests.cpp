// SPDX-License-Identifier: MIT
#include "fields/field_file.hpp"

#include <fstream>
#include <numeric>

#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

using namespace fields;

TEST_CASE("frames and the XDMF text name the same datasets") {
    const support::TemporaryFolder folder;
    files::Hdf5File file(folder / "a.h5", files::Open::create);
    FieldFile frames(file, folder / "a.h5", Grid{{2, 3, 4}, {2.0, 2.0, 0.2}});
    std::vector<double> values(24);
    std::iota(values.begin(), values.end(), 0.0);
    frames.add_frame(1.5, 3, 0.25, 0.7, {{"density", values}});
    frames.write_xdmf();
    CHECK(file.shape("/frames/00000/density") == files::Shape{4, 3, 2});
    CHECK(file.read<double>("/frames/00000/density") == values);
    CHECK(file.read_number("/frames/00000/phase") == 0.25);
    std::ifstream text(folder / "a.xdmf");
    const std::string xdmf{std::istreambuf_iterator<char>(text), {}};
    CHECK_THAT(xdmf, Contains("a.h5:/frames/00000/density") && Contains("Dimensions=\"5 4 3\"") &&
                         Contains("0.7 0 0") && Contains("0.2 2 2"));
    CHECK_THROWS_AS(frames.add_frame(2.0, 3, 0.5, 0.7, {{"density", std::span<const double>(values).first(3)}}),
                    std::invalid_argument);
}
