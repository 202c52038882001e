// SPDX-License-Identifier: MIT
#include "files/hdf5.hpp"

#include <array>
#include <numeric>

#include "files/errors.hpp"
#include "files/provenance.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

using namespace files;

TEST_CASE("arrays, texts, numbers and attributes survive a round trip") {
    const support::TemporaryFolder folder;
    std::vector<double> large(20000);
    std::iota(large.begin(), large.end(), 0.5);
    {
        Hdf5File file(folder / "a.h5", Open::create);
        file.write<double>("/group/deep/matrix", large, {100, 200});
        file.write("/count", std::int64_t{-7});
        file.write_text("/text", "nu = pi n / 6");
        file.write_text("/nothing", "");
        file.attribute("/group", "units", "sigma");
        file.close();
    }
    const Hdf5File file(folder / "a.h5", Open::read);
    CHECK(file.read<double>("/group/deep/matrix") == large);
    CHECK(file.shape("/group/deep/matrix") == Shape{100, 200});
    CHECK(file.read<std::int64_t>("/count") == std::vector<std::int64_t>{-7});
    CHECK(file.read_text("/text") == "nu = pi n / 6");
    CHECK(file.read_text("/nothing").empty());
    CHECK(file.read_text_attribute("/group", "units") == "sigma");
    CHECK(file.has("/group/deep"));
    CHECK_FALSE(file.has("/group/shallow/matrix"));
    CHECK_THROWS_AS(file.read<double>("/absent"), Damaged);
}

TEST_CASE("slabs append along the first axis") {
    const support::TemporaryFolder folder;
    Hdf5File file(folder / "a.h5", Open::create);
    for (double i = 0.0; i < 3.0; ++i) file.append<double>("/series", std::array{i, 10.0 * i}, {2});
    CHECK(file.shape("/series") == Shape{3, 2});
    CHECK(file.read<double>("/series") == std::vector<double>{0, 0, 1, 10, 2, 20});
    CHECK_THROWS_AS(file.append<double>("/series", std::array{1.0}, {2}), std::logic_error);
}

TEST_CASE("a data set takes as many values as its shape has, neither fewer nor more") {
    const support::TemporaryFolder folder;
    Hdf5File file(folder / "a.h5", Open::create);
    for (const std::size_t values : {5u, 7u})
        CHECK_THROWS_AS(file.write<double>("/field", std::vector<double>(values), {2, 3}), std::logic_error);
    file.create<double>("/rows", {2, 3});
    CHECK_THROWS_AS(file.write_rows<double>("/rows", 0, std::vector<double>(4)), std::logic_error);
    CHECK_THROWS_AS(file.write_rows<double>("/rows", 1, std::vector<double>(6)), std::logic_error);
    file.write_rows<double>("/rows", 1, std::vector<double>{1, 2, 3});
    CHECK(file.read<double>("/rows") == std::vector<double>{0, 0, 0, 1, 2, 3});
}

TEST_CASE("a hard link is the same dataset") {
    const support::TemporaryFolder folder;
    Hdf5File file(folder / "a.h5", Open::create);
    file.write("/time", std::vector<double>{1, 2});
    file.hard_link("/time", "/box/edges/time");
    CHECK(file.read<double>("/box/edges/time") == std::vector<double>{1, 2});
}

TEST_CASE("what is no HDF5 file, and what is not there, are told apart") {
    const support::TemporaryFolder folder;
    CHECK_THROWS_AS(Hdf5File(folder / "absent.h5", Open::read), NoInput);
    CHECK_THROWS_AS(Hdf5File(folder / "no_folder/a.h5", Open::create), CannotCreate);
    CHECK_THROWS_AS(Hdf5File(folder.path(), Open::read), Damaged);
}

TEST_CASE("every file says where it comes from") {
    const support::TemporaryFolder folder;
    Hdf5File file(folder / "a.h5", Open::create);
    write_provenance(file, {"[plate]\n", 7, ""});
    CHECK(file.read_text("/provenance/scene") == "[plate]\n");
    CHECK(file.read<std::uint64_t>("/provenance/seed") == std::vector<std::uint64_t>{7});
    for (const char* name : {"program", "git_hash", "compiler", "compiler_flags"}) {
        CHECK_FALSE(file.read_text(std::string("/provenance/") + name).empty());
    }
}
