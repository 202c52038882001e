// SPDX-License-Identifier: MIT
#include "files/checkpoint_file.hpp"

#include <fstream>
#include <random>

#include "files/errors.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

using namespace files;

namespace {

CheckpointWriter example() {
    CheckpointWriter out;
    out.put("positions", std::vector<double>{1.5, -2.5, 3.25});
    out.put("cycle", std::int64_t{42});
    out.put("empty", std::vector<std::int32_t>{});
    out.put_text("scene", "[plate]\nacceleration = 3\n");
    return out;
}

std::string content_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write_content(const std::filesystem::path& path, const std::string& content) {
    std::ofstream(path, std::ios::binary) << content;
}

}  // namespace

TEST_CASE("a checkpoint gives back what was put in") {
    const support::TemporaryFolder folder;
    example().commit(folder / "a.checkpoint");
    const CheckpointReader in(folder / "a.checkpoint");
    CHECK(in.take<double>("positions") == std::vector<double>{1.5, -2.5, 3.25});
    CHECK(in.take_one<std::int64_t>("cycle") == 42);
    CHECK(in.take<std::int32_t>("empty").empty());
    CHECK(in.take_text("scene") == "[plate]\nacceleration = 3\n");
    CHECK_THROWS_AS(in.take<double>("velocities"), Damaged);
    CHECK_THROWS_AS(in.take<float>("positions"), Damaged);
    std::array<double, 2> two;
    CHECK_THROWS_AS(in.take_into("positions", std::span<double>(two)), Damaged);
}

TEST_CASE("equal states have equal hashes and files, and any change shows") {
    const support::TemporaryFolder folder;
    example().commit(folder / "a");
    example().commit(folder / "b");
    CHECK(content_of(folder / "a") == content_of(folder / "b"));
    CheckpointWriter other = example();
    other.put("one_more", 1.0);
    CHECK(other.hash() != example().hash());
    CHECK_THROWS_AS(other.put("one_more", 2.0), std::logic_error);
}

TEST_CASE("every truncation of a checkpoint is refused") {
    const support::TemporaryFolder folder;
    example().commit(folder / "a");
    const std::string whole = content_of(folder / "a");
    for (std::size_t length = 0; length < whole.size(); ++length) {
        write_content(folder / "cut", whole.substr(0, length));
        INFO("length " << length << " of " << whole.size());
        CHECK_THROWS_AS(CheckpointReader(folder / "cut"), Damaged);
    }
    write_content(folder / "long", whole + "x");
    CHECK_THROWS_AS(CheckpointReader(folder / "long"), Damaged);
}

TEST_CASE("every flipped bit of a checkpoint is noticed") {
    const support::TemporaryFolder folder;
    example().commit(folder / "a");
    const std::string whole = content_of(folder / "a");
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        std::string flipped = whole;
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
        write_content(folder / "flipped", flipped);
        INFO("bit " << bit);
        CHECK_THROWS_AS(CheckpointReader(folder / "flipped"), Damaged);
    }
}

TEST_CASE("a checkpoint that cannot be written leaves the earlier one in place") {
    const support::TemporaryFolder folder;
    example().commit(folder / "a");
    CHECK_THROWS_AS(example().commit(folder / "no_such_folder/a"), CannotCreate);
    CHECK_THROWS_AS(CheckpointReader(folder / "absent"), NoInput);
    CHECK(CheckpointReader(folder / "a").has("cycle"));
    // No temporary file stays behind.
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("a checkpoint written section by section reads as one that was collected, in whatever order it came") {
    const support::TemporaryFolder folder;
    CheckpointFile out(folder / "a");
    out.put_text("scene", "[plate]\nacceleration = 3\n");
    out.put("positions", std::vector<double>(300'000, 1.5));  // more than a piece of the checksum
    CHECK_THROWS_AS(out.put("scene", 1.0), std::logic_error);
    CHECK_FALSE(std::filesystem::exists(folder / "a"));
    out.commit();
    const CheckpointReader in(folder / "a");
    CHECK(in.take<double>("positions") == std::vector<double>(300'000, 1.5));
    CHECK(in.take_text("scene") == "[plate]\nacceleration = 3\n");
}

TEST_CASE("a checkpoint that is not committed leaves the one before it, and nothing of its own") {
    const support::TemporaryFolder folder;
    example().commit(folder / "a");
    const std::string before = content_of(folder / "a");
    {
        CheckpointFile out(folder / "a");
        out.put("cycle", std::int64_t{43});
    }
    CHECK(content_of(folder / "a") == before);
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}
