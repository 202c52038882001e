// SPDX-License-Identifier: MIT
// A checkpoint written section by section as it is put together, so that it takes no memory of its own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>

#include "files/checkpoint.hpp"

namespace shaken::files {

class CheckpointFile : public CheckpointWriter {
  public:
    /// Begins a temporary file beside `path`, which goes if it is not committed. Throws CannotCreate.
    explicit CheckpointFile(std::filesystem::path path);
    CheckpointFile(const CheckpointFile&) = delete;
    CheckpointFile& operator=(const CheckpointFile&) = delete;
    ~CheckpointFile() override;

    /// Checksum, fsync, rename, fsync of the folder. Throws WriteFailed, and then whatever stood at the path before
    /// still stands there.
    void commit();

  private:
    friend class CheckpointWriter;  // hands over what it has collected
    void put_bytes(std::string_view name, std::span<const std::byte> bytes, std::size_t item_size) override;
    void write(const void* bytes, std::size_t size);
    void write_at(std::uint64_t place, const void* bytes, std::size_t size);
    void check(bool is_well) const;

    std::filesystem::path path_, temporary_;
    int descriptor_ = -1;
    std::set<std::string, std::less<>> names_;
    std::uint64_t body_size_ = 0;
};

}  // namespace shaken::files
