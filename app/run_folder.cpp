// SPDX-License-Identifier: MIT
#include "app/run_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <set>

#include "files/errors.hpp"

namespace shaken::app {

namespace {

/// What a run leaves in its folder, and so what --overwrite may remove.
const std::set<std::string> own_files{"scene.toml",   "md.h5",          "md.checkpoint",        "md.status.json",
                                      "continuum.h5", "continuum.xdmf", "continuum.checkpoint", "continuum.status.json",
                                      "compare.h5",   "summary.json",   "report.html",          "figures"};

const std::string lock_prefix = ".lock.";

bool is_lock(const std::string& name) { return name.starts_with(lock_prefix); }

/// Removes what a run left; of figures/ only what it drew.
void remove_own(const std::filesystem::path& path) {
    std::error_code ignored;
    if (path.filename() != "figures") {
        std::filesystem::remove_all(path, ignored);
        return;
    }
    for (const auto& entry : std::filesystem::directory_iterator(path, ignored)) {
        if (entry.path().filename().string().starts_with("figure_")) std::filesystem::remove(entry.path(), ignored);
    }
    std::filesystem::remove(path, ignored);  // goes only if it is empty now
}

}  // namespace

/// Throws if a run holds any of the folder's locks.
void refuse_folder_in_use(const std::filesystem::path& folder) {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        if (is_lock(name)) FolderLock(folder, name.substr(lock_prefix.size()));
    }
}

void prepare_folder(const std::filesystem::path& folder, bool overwrite) {
    std::error_code error;
    if (std::filesystem::exists(folder, error) && !std::filesystem::is_directory(folder, error)) {
        throw files::CannotCreate(fmt::format("{}: is a file, not a folder", folder.string()));
    }
    std::filesystem::create_directories(folder, error);
    if (error) throw files::CannotCreate(fmt::format("{}: cannot be created: {}", folder.string(), error.message()));
    refuse_folder_in_use(folder);
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string();
        if (is_lock(name)) continue;
        if (!overwrite) {
            throw files::CannotCreate(fmt::format("{}: holds {} and perhaps more; give another folder, or --overwrite",
                                                  folder.string(), name));
        }
        if (own_files.contains(name)) remove_own(entry.path());
    }
    if (::access(folder.c_str(), W_OK | X_OK) != 0) {
        throw files::CannotCreate(fmt::format("{}: cannot be written into: {}", folder.string(), std::strerror(errno)));
    }
}

FolderLock::FolderLock(const std::filesystem::path& folder, const std::string& name)
    : path_(folder / (lock_prefix + name)) {
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor_ < 0) {
        throw files::CannotCreate(fmt::format("{}: cannot be written into: {}", folder.string(), std::strerror(errno)));
    }
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
        ::close(descriptor_);
        throw files::CannotCreate(fmt::format("{}: another run of {} is at work there", folder.string(), name));
    }
}

FolderLock::~FolderLock() {
    ::unlink(path_.c_str());
    ::close(descriptor_);
}

}  // namespace shaken::app
