// SPDX-License-Identifier: MIT
#include "app/run_folder.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "files/errors.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

using namespace app;

TEST_CASE("a folder that holds anything is refused, and --overwrite removes only what a run left") {
    const support::TemporaryFolder folder;
    CHECK_NOTHROW(prepare_folder(folder / "new/deep", false));
    CHECK_NOTHROW(prepare_folder(folder / "new/deep", false));
    std::ofstream(folder / "new/deep/md.h5") << "old";
    std::ofstream(folder / "new/deep/notes.txt") << "mine";
    CHECK_THROWS_AS(prepare_folder(folder / "new/deep", false), files::CannotCreate);
    CHECK_NOTHROW(prepare_folder(folder / "new/deep", true));
    CHECK_FALSE(std::filesystem::exists(folder / "new/deep/md.h5"));
    CHECK(std::filesystem::exists(folder / "new/deep/notes.txt"));
    CHECK_THROWS_AS(prepare_folder(folder / "new/deep/notes.txt", true), files::CannotCreate);
    CHECK_THROWS_AS(prepare_folder("/proc/no", false), files::CannotCreate);
}

TEST_CASE("only one run works in a folder at a time") {
    const support::TemporaryFolder folder;
    {
        const FolderLock first(folder.path(), "md");
        CHECK_THROWS_AS(FolderLock(folder.path(), "md"), files::CannotCreate);
        CHECK_NOTHROW(FolderLock(folder.path(), "continuum"));
        CHECK_THROWS_AS(prepare_folder(folder.path(), true), files::CannotCreate);
    }
    CHECK_NOTHROW(prepare_folder(folder.path(), false));
    CHECK_NOTHROW(FolderLock(folder.path(), "md"));
}
