// SPDX-License-Identifier: MIT
#include "run/folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>
#include <string_view>

#include "files/errors.hpp"

namespace shaken::run {

namespace {

/// What a run leaves in its folder, and so what --overwrite may remove.
const std::set<std::string> own_files{
    "scene.toml",   "md.h5",          "md.checkpoint",        "md.stream",        "md.status.json",
    "continuum.h5", "continuum.xdmf", "continuum.checkpoint", "continuum.stream", "continuum.status.json",
    "compare.h5",   "summary.json",   "report.html",          "figures",          "verification.csv"};

const std::string lock_prefix = ".lock.";

bool is_lock(const std::string& name) { return name.starts_with(lock_prefix); }

/// What files::write_atomically leaves of one of these where the program is killed within it: NAME.PROCESS.tmp.
bool is_half_written(const std::string& name) {
    constexpr std::string_view ending = ".tmp";
    if (!name.ends_with(ending)) return false;
    const std::string stem = name.substr(0, name.size() - ending.size());
    const std::size_t dot = stem.rfind('.');
    return dot != std::string::npos && own_files.contains(stem.substr(0, dot)) && dot + 1 < stem.size() &&
           stem.find_first_not_of("0123456789", dot + 1) == std::string::npos;
}

bool says(const std::filesystem::path& path, const std::string& text) {
    std::ifstream file(path);
    return std::string(std::istreambuf_iterator<char>(file), {}) == text;
}

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

void prepare_folder(const std::filesystem::path& folder, bool overwrite, const std::string& scene) {
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
        if (is_half_written(name)) {
            std::error_code ignored;
            std::filesystem::remove(entry.path(), ignored);
            continue;
        }
        if (!overwrite && name == "scene.toml" && says(entry.path(), scene)) continue;
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

}  // namespace shaken::run
