// SPDX-License-Identifier: MIT
#include "files/record_log.hpp"

#include "files/errors.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

using namespace files;

namespace {

using Records = std::vector<std::pair<std::uint64_t, std::vector<double>>>;

Records records_of(const std::filesystem::path& path, std::uint64_t length) {
    Records all;
    for (RecordReader in(path, length); in.next();) all.emplace_back(in.kind(), in.values());
    return all;
}

void flip_byte(const std::filesystem::path& path, std::uint64_t at) {
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    file.seekg(static_cast<std::streamoff>(at));
    const char changed = static_cast<char>(file.get() ^ 1);
    file.seekp(static_cast<std::streamoff>(at));
    file.put(changed);
}

}  // namespace

TEST_CASE("a log gives back its records in order, of any length, up to the length asked for") {
    const support::TemporaryFolder folder;
    RecordLog log(folder / "a", 0);
    log.append(1, std::vector<double>{1.5, -2.0});
    const std::uint64_t two = (log.append(7, {}), log.sync());
    log.append(2, std::vector<double>(200'000, 0.25));  // more than is held in memory
    const std::uint64_t three = log.sync();
    CHECK(std::filesystem::file_size(folder / "a") == three);
    const Records all = records_of(folder / "a", three);
    REQUIRE(all.size() == 3);
    CHECK(all[0] == Records::value_type{1, {1.5, -2.0}});
    CHECK(all[1] == Records::value_type{7, {}});
    CHECK(all[2].second.size() == 200'000);
    CHECK(records_of(folder / "a", two).size() == 2);
}

TEST_CASE("records can be counted without reading them") {
    const support::TemporaryFolder folder;
    RecordLog log(folder / "a", 0);
    for (int i = 0; i < 3; ++i) log.append(5, std::vector<double>{1.0 * i, 2.0});
    RecordReader in(folder / "a", log.sync());
    REQUIRE((in.next() && in.next() && in.next()));
    CHECK(in.count() == 2);
    CHECK(in.values() == std::vector<double>{2.0, 2.0});
    CHECK_FALSE(in.next());
}

TEST_CASE("a log goes on from a length, and what stood behind it is gone") {
    const support::TemporaryFolder folder;
    std::uint64_t length = 0;
    {
        RecordLog log(folder / "a", 0);
        log.append(1, std::vector<double>{1.0});
        length = log.sync();
        log.append(1, std::vector<double>{2.0, 2.0});
        log.sync();
    }
    std::filesystem::resize_file(folder / "a", std::filesystem::file_size(folder / "a") - 3);  // killed within a write
    RecordLog log(folder / "a", length);
    log.append(1, std::vector<double>{3.0});
    CHECK(records_of(folder / "a", log.sync()) == Records{{1, {1.0}}, {1, {3.0}}});
}

TEST_CASE("a log that is short, damaged or not a log is refused") {
    const support::TemporaryFolder folder;
    std::uint64_t length = 0;
    {
        RecordLog log(folder / "a", 0);
        log.append(1, std::vector<double>{1.0, 2.0});
        length = log.sync();
    }
    CHECK_THROWS_AS(RecordLog(folder / "a", length + 1), Damaged);
    CHECK_THROWS_AS(RecordLog(folder / "none", length), Damaged);
    CHECK_THROWS_AS(RecordReader(folder / "a", length + 1), Damaged);
    CHECK_THROWS_AS(RecordReader(folder / "none", length), NoInput);
    CHECK_THROWS_AS(records_of(folder / "a", length - 8), Damaged);
    flip_byte(folder / "a", length - 1);
    CHECK_THROWS_AS(records_of(folder / "a", length), Damaged);
    flip_byte(folder / "a", length - 1);
    flip_byte(folder / "a", 8);  // the kind, of which the checksum knows
    CHECK_THROWS_AS(records_of(folder / "a", length), Damaged);
    flip_byte(folder / "a", 0);
    CHECK_THROWS_AS(records_of(folder / "a", length), Damaged);
}
