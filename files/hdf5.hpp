// SPDX-License-Identifier: MIT
// Thin RAII handles on the HDF5 C library: open, write and read whole arrays, attributes, hard links.
// Errors become the types of files/errors.hpp; the library's own error printing is switched off.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shaken::files {

using Shape = std::vector<std::uint64_t>;

/// Owns one HDF5 identifier and closes it.
class Handle {
  public:
    using Close = herr_t (*)(hid_t);
    Handle() = default;
    Handle(hid_t id, Close close) : id_(id), close_(close) {}
    Handle(Handle&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = -1; }
    Handle& operator=(Handle&& other) noexcept;
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle();
    hid_t id() const { return id_; }

  private:
    hid_t id_ = -1;
    Close close_ = nullptr;
};

enum class Open { create, read, append };

/// An HDF5 file. Paths inside are absolute ("/particles/all/position"); missing groups are made on writing.
class Hdf5File {
  public:
    /// Throws NoInput, Damaged or CannotCreate. Open::create replaces an existing file. Created with the format
    /// bounds of HDF5 1.8, which every reader of the field understands.
    Hdf5File(const std::filesystem::path& path, Open how);

    /// Whether a file is there that opens as HDF5.
    static bool is_readable(const std::filesystem::path& path);

    /// Writes a whole array in row-major order; element types double, float, int32, int64, uint64. Arrays of more
    /// than 4096 items are compressed.
    template <class T>
    void write(const std::string& name, std::span<const T> values, const Shape& shape);
    template <class T>
    void write(const std::string& name, const std::vector<T>& values) {
        write(name, std::span<const T>(values), Shape{values.size()});
    }
    void write(const std::string& name, double value) { write<double>(name, std::span(&value, 1), Shape{}); }
    void write(const std::string& name, std::int64_t value) {
        write<std::int64_t>(name, std::span(&value, 1), Shape{});
    }
    void write_text(const std::string& name, std::string_view text);

    /// The same in pieces, for what is larger than memory: makes the dataset, then fills it along its first axis, from
    /// row `first` on.
    template <class T>
    void create(const std::string& name, const Shape& shape);
    template <class T>
    void write_rows(const std::string& name, std::uint64_t first, std::span<const T> values);

    /// Appends one slab along an extensible first axis; makes the dataset at the first call. `shape` is one slab's.
    template <class T>
    void append(const std::string& name, std::span<const T> values, const Shape& shape);

    /// Attributes of a group or dataset, which must exist (groups are made).
    void attribute(const std::string& object, const std::string& name, std::string_view text);
    void attribute(const std::string& object, const std::string& name, double value);
    void attribute(const std::string& object, const std::string& name, std::int64_t value);
    void attribute(const std::string& object, const std::string& name, std::span<const std::int32_t> values);
    void attribute(const std::string& object, const std::string& name, const std::vector<std::string>& texts);

    void make_group(const std::string& name);
    void hard_link(const std::string& existing, const std::string& name);

    bool has(const std::string& name) const;
    template <class T>
    std::vector<T> read(const std::string& name) const;
    Shape shape(const std::string& name) const;
    double read_number(const std::string& name) const;
    std::string read_text(const std::string& name) const;
    std::string read_text_attribute(const std::string& object, const std::string& name) const;
    double read_number_attribute(const std::string& object, const std::string& name) const;

    /// Everything written so far survives the death of the process. Throws WriteFailed (disk full).
    void flush();

    /// Flushes and closes, throwing WriteFailed where a destructor could not.
    void close();

  private:
    std::string path_;
    Handle file_;
};

}  // namespace shaken::files
