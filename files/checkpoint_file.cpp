// SPDX-License-Identifier: MIT
// Layout (little endian): magic "SHKNCKP1", length of the body (u64), XXH3-128 of the body (16 bytes), body.
// Body: number of sections (u64), then for each: length of the name, name, item size, length in bytes, bytes. The
// number and the checksum are known last and written into their places then.
#include "files/checkpoint_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <xxhash.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <vector>

#include "files/atomic_write.hpp"
#include "files/checkpoint_layout.hpp"
#include "files/errors.hpp"

namespace shaken::files {

CheckpointFile::CheckpointFile(std::filesystem::path path)
    : path_(std::move(path)), temporary_(fmt::format("{}.{}.tmp", path_.string(), ::getpid())) {
    descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (descriptor_ < 0)
        throw CannotCreate(fmt::format("{}: cannot be created: {}", path_.string(), std::strerror(errno)));
    const std::uint64_t no_sections = 0;
    check(::lseek(descriptor_, checkpoint_layout::header_size, SEEK_SET) >= 0);
    write(&no_sections, sizeof no_sections);
}

CheckpointFile::~CheckpointFile() {
    if (descriptor_ < 0) return;
    ::close(descriptor_);
    ::unlink(temporary_.c_str());
}

void CheckpointFile::check(bool is_well) const {
    if (!is_well) throw WriteFailed(fmt::format("{}: cannot be written: {}", path_.string(), std::strerror(errno)));
}

void CheckpointFile::write(const void* bytes, std::size_t size) {
    const char* from = static_cast<const char*>(bytes);
    for (std::size_t left = size; left > 0;) {
        const ssize_t written = ::write(descriptor_, from, left);
        if (written < 0 && errno == EINTR) continue;
        check(written > 0);
        from += written;
        left -= static_cast<std::size_t>(written);
    }
    body_size_ += size;
}

void CheckpointFile::write_at(std::uint64_t place, const void* bytes, std::size_t size) {
    check(::pwrite(descriptor_, bytes, size, static_cast<off_t>(place)) == static_cast<ssize_t>(size));
}

void CheckpointFile::put_bytes(std::string_view name, std::span<const std::byte> bytes, std::size_t item_size) {
    if (!names_.emplace(name).second)
        throw std::logic_error(fmt::format("checkpoint section '{}' is written twice", name));
    const auto number = [this](std::uint64_t value) { write(&value, sizeof value); };
    number(name.size());
    write(name.data(), name.size());
    number(item_size);
    number(bytes.size());
    write(bytes.data(), bytes.size());
}

void CheckpointFile::commit() {
    const std::uint64_t sections = names_.size();
    write_at(checkpoint_layout::header_size, &sections, sizeof sections);
    const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(), XXH3_freeState);
    XXH3_128bits_reset(state.get());
    std::vector<char> piece(1 << 20);
    for (std::uint64_t read = 0; read < body_size_;) {
        const ssize_t got =
            ::pread(descriptor_, piece.data(), piece.size(), static_cast<off_t>(checkpoint_layout::header_size + read));
        check(got > 0);
        XXH3_128bits_update(state.get(), piece.data(), static_cast<std::size_t>(got));
        read += static_cast<std::uint64_t>(got);
    }
    XXH128_canonical_t sum;
    XXH128_canonicalFromHash(&sum, XXH3_128bits_digest(state.get()));
    const std::string header = checkpoint_layout::header(body_size_, sum);
    write_at(0, header.data(), header.size());
    check(::fsync(descriptor_) == 0);
    ::close(descriptor_);
    descriptor_ = -1;
    take_its_place(temporary_, path_);
}

}  // namespace shaken::files
