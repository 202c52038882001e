// SPDX-License-Identifier: MIT
// The folder of a run: what lies where, who may write into it.
#pragma once

#include <filesystem>
#include <string>

namespace shaken::run {

/// Paths of one engine's files ("md" or "continuum") in a run folder.
struct EngineFiles {
    std::filesystem::path folder;
    std::string engine;
    std::filesystem::path output() const { return folder / (engine + ".h5"); }
    std::filesystem::path checkpoint() const { return folder / (engine + ".checkpoint"); }
    std::filesystem::path stream() const { return folder / (engine + ".stream"); }
    std::filesystem::path status() const { return folder / (engine + ".status.json"); }
};

/// Makes the folder. A folder that holds anything is refused (files::CannotCreate) unless `overwrite`, which removes
/// what an earlier run left there and touches nothing else. What a run leaves that is killed before its first
/// checkpoint counts for nothing: half-written files, and a scene.toml that says just what `scene` says.
void prepare_folder(const std::filesystem::path& folder, bool overwrite, const std::string& scene);

/// Keeps a second run out of the same folder for as long as it lives; throws files::CannotCreate if one is there.
class FolderLock {
  public:
    FolderLock(const std::filesystem::path& folder, const std::string& name);
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    ~FolderLock();

  private:
    std::filesystem::path path_;
    int descriptor_ = -1;
};

}  // namespace shaken::run
