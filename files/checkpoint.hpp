// SPDX-License-Identifier: MIT
// The checkpoint container: named arrays in one file, written whole or not at all, verified before it is believed.
// Layout in docs/formats.md. A reader checks length and checksum first, so a damaged file is refused in milliseconds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace shaken::files {

/// Collects the sections of a checkpoint in memory, for their hash, or to be committed later; what is large goes to a
/// CheckpointFile (files/checkpoint_file.hpp), which holds none.
class CheckpointWriter {
  public:
    virtual ~CheckpointWriter() = default;
    /// Stores trivially copyable values under a name that must be new; throws std::logic_error if it is not.
    template <class T>
    void put(std::string_view name, std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        put_bytes(name, std::as_bytes(values), sizeof(T));
    }
    template <class T>
    void put(std::string_view name, const std::vector<T>& values) {
        put(name, std::span<const T>(values));
    }
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void put(std::string_view name, const T& value) { put(name, std::span<const T>(&value, 1)); }
    void put_text(std::string_view name, std::string_view text);

    /// Temporary file beside `path`, checksum, fsync, rename, fsync of the folder. Throws CannotCreate or WriteFailed,
    /// and then whatever stood at `path` before still stands there.
    void commit(const std::filesystem::path& path) const;

    /// 64-bit hash of all sections: equal states have equal hashes.
    std::uint64_t hash() const;

  private:
    struct Section {
        std::uint64_t item_size = 0;
        std::vector<std::byte> bytes;
    };
    virtual void put_bytes(std::string_view name, std::span<const std::byte> bytes, std::size_t item_size);
    std::map<std::string, Section, std::less<>> sections_;
};

/// Reads a checkpoint; the constructor throws NoInput or Damaged (with the reason), never returns half a state.
class CheckpointReader {
  public:
    explicit CheckpointReader(const std::filesystem::path& path);

    /// The stored values; throws Damaged if the section is absent or holds another type's size.
    template <class T>
    std::vector<T> take(std::string_view name) const {
        static_assert(std::is_trivially_copyable_v<T>);
        const std::span<const std::byte> bytes = take_bytes(name, sizeof(T));
        std::vector<T> values(bytes.size() / sizeof(T));
        if (!values.empty()) copy(bytes, values.data());
        return values;
    }
    /// Fills an existing array; throws Damaged if the stored length differs.
    template <class T>
    void take_into(std::string_view name, std::span<T> values) const {
        const std::span<const std::byte> bytes = take_bytes(name, sizeof(T));
        expect_length(name, bytes.size() / sizeof(T), values.size());
        if (!values.empty()) copy(bytes, values.data());
    }
    template <class T>
    T take_one(std::string_view name) const {
        T value;
        take_into(name, std::span<T>(&value, 1));
        return value;
    }
    std::string take_text(std::string_view name) const;
    bool has(std::string_view name) const { return sections_.contains(name); }

  private:
    struct Section {
        std::uint64_t item_size = 0;
        std::span<const std::byte> bytes;
    };
    std::span<const std::byte> take_bytes(std::string_view name, std::size_t item_size) const;
    void expect_length(std::string_view name, std::size_t stored, std::size_t wanted) const;
    static void copy(std::span<const std::byte> from, void* to);
    std::string path_;
    std::vector<std::byte> content_;
    std::map<std::string, Section, std::less<>> sections_;
};

}  // namespace shaken::files
