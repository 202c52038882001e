// SPDX-License-Identifier: MIT
#include "files/atomic_write.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "files/errors.hpp"

namespace shaken::files {

namespace {

/// Owns a file descriptor.
struct Descriptor {
    int number = -1;
    ~Descriptor() {
        if (number >= 0) ::close(number);
    }
};

bool write_all(int descriptor, std::string_view content) {
    while (!content.empty()) {
        const ssize_t written = ::write(descriptor, content.data(), content.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        content.remove_prefix(static_cast<std::size_t>(written));
    }
    return ::fsync(descriptor) == 0;
}

}  // namespace

void take_its_place(const std::filesystem::path& temporary, const std::filesystem::path& path) {
    if (::rename(temporary.c_str(), path.c_str()) != 0) {
        const std::string reason = std::strerror(errno);
        ::unlink(temporary.c_str());
        throw WriteFailed(fmt::format("{}: cannot be replaced: {}", path.string(), reason));
    }
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    const Descriptor directory{::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
    if (directory.number >= 0) ::fsync(directory.number);
}

void write_atomically(const std::filesystem::path& path, std::string_view content) {
    const std::string temporary = fmt::format("{}.{}.tmp", path.string(), ::getpid());
    {
        Descriptor file{::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)};
        if (file.number < 0) {
            throw CannotCreate(fmt::format("{}: cannot be created: {}", path.string(), std::strerror(errno)));
        }
        if (!write_all(file.number, content)) {
            const std::string reason = std::strerror(errno);
            ::unlink(temporary.c_str());
            throw WriteFailed(fmt::format("{}: cannot be written: {}", path.string(), reason));
        }
    }
    take_its_place(temporary, path);
}

}  // namespace shaken::files
