// SPDX-License-Identifier: MIT
#include "run/folder.hpp"

#include <fstream>

#include "files/errors.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

using namespace run;

TEST_CASE("a folder that holds anything is refused, and --overwrite removes only what a run left") {
    const support::TemporaryFolder folder;
    CHECK_NOTHROW(prepare_folder(folder / "new/deep", false, "the scene\n"));
    CHECK_NOTHROW(prepare_folder(folder / "new/deep", false, "the scene\n"));
    std::ofstream(folder / "new/deep/md.h5") << "old";
    std::ofstream(folder / "new/deep/notes.txt") << "mine";
    CHECK_THROWS_AS(prepare_folder(folder / "new/deep", false, "the scene\n"), files::CannotCreate);
    CHECK_NOTHROW(prepare_folder(folder / "new/deep", true, "the scene\n"));
    CHECK_FALSE(std::filesystem::exists(folder / "new/deep/md.h5"));
    CHECK(std::filesystem::exists(folder / "new/deep/notes.txt"));
    CHECK_THROWS_AS(prepare_folder(folder / "new/deep/notes.txt", true, "the scene\n"), files::CannotCreate);
    CHECK_THROWS_AS(prepare_folder("/proc/no", false, "the scene\n"), files::CannotCreate);
}

TEST_CASE("what a run leaves that is killed before its first checkpoint stands in nobody's way") {
    const support::TemporaryFolder folder;
    const auto write = [&](const char* name, const char* text) { std::ofstream(folder / name) << text; };
    write("md.checkpoint.26828.tmp", "half");
    write("scene.toml", "the scene\n");
    CHECK_NOTHROW(prepare_folder(folder.path(), false, "the scene\n"));
    CHECK_FALSE(std::filesystem::exists(folder / "md.checkpoint.26828.tmp"));
    CHECK_THROWS_AS(prepare_folder(folder.path(), false, "another scene\n"), files::CannotCreate);
    CHECK(std::filesystem::exists(folder / "scene.toml"));
    for (const char* mine : {"notes.1.tmp", "md.checkpoint.tmp", "md.h5.old.tmp"}) {
        write(mine, "mine");
        CHECK_THROWS_AS(prepare_folder(folder.path(), false, "the scene\n"), files::CannotCreate);
        CHECK(std::filesystem::remove(folder / mine));
    }
}

TEST_CASE("only one run works in a folder at a time") {
    const support::TemporaryFolder folder;
    {
        const FolderLock first(folder.path(), "md");
        CHECK_THROWS_AS(FolderLock(folder.path(), "md"), files::CannotCreate);
        CHECK_NOTHROW(FolderLock(folder.path(), "continuum"));
        CHECK_THROWS_AS(prepare_folder(folder.path(), true, "the scene\n"), files::CannotCreate);
    }
    CHECK_NOTHROW(prepare_folder(folder.path(), false, "the scene\n"));
    CHECK_NOTHROW(FolderLock(folder.path(), "md"));
}
