// SPDX-License-Identifier: MIT
#include "files/hdf5.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "files/errors.hpp"

namespace shaken::files {

namespace {

template <class T>
hid_t native_type();
template <>
hid_t native_type<double>() {
    return H5T_NATIVE_DOUBLE;
}
template <>
hid_t native_type<float>() {
    return H5T_NATIVE_FLOAT;
}
template <>
hid_t native_type<std::int32_t>() {
    return H5T_NATIVE_INT32;
}
template <>
hid_t native_type<std::int64_t>() {
    return H5T_NATIVE_INT64;
}
template <>
hid_t native_type<std::uint64_t>() {
    return H5T_NATIVE_UINT64;
}

constexpr std::uint64_t compressed_from = 4096;  // items; smaller arrays gain nothing
constexpr unsigned compression_level = 4;

Handle checked(hid_t id, Handle::Close close, const std::string& path, const std::string& what) {
    if (id < 0) throw WriteFailed(fmt::format("{}: {} failed", path, what));
    return Handle(id, close);
}

void check(herr_t status, const std::string& path, const std::string& what) {
    if (status < 0) throw WriteFailed(fmt::format("{}: {} failed (disk full?)", path, what));
}

std::uint64_t product(const Shape& shape) {
    std::uint64_t n = 1;
    for (const std::uint64_t extent : shape) n *= extent;
    return n;
}

std::vector<hsize_t> extents(const Shape& shape) { return {shape.begin(), shape.end()}; }

Handle space_of(const Shape& shape) {
    const std::vector<hsize_t> size = extents(shape);
    return {
        shape.empty() ? H5Screate(H5S_SCALAR) : H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr),
        H5Sclose};
}

/// Errors are ours to report. What cannot be written when a disk is full cannot be written at exit either: the
/// library's own attempt would crash.
void prepare_library() {
    [[maybe_unused]] static const bool once = (H5dont_atexit(), true);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Handle make_missing_groups() {
    Handle properties(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    H5Pset_create_intermediate_group(properties.id(), 1);
    return properties;
}

Handle text_type(std::size_t size) {
    Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.id(), size == 0 ? 1 : size);
    H5Tset_cset(type.id(), H5T_CSET_UTF8);
    return type;
}

}  // namespace

Handle& Handle::operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
}

Handle::~Handle() {
    if (id_ >= 0 && close_) close_(id_);
}

bool Hdf5File::is_readable(const std::filesystem::path& path) {
    prepare_library();
    return std::filesystem::exists(path) && H5Fis_hdf5(path.c_str()) > 0 &&
           Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose).id() >= 0;
}

Hdf5File::Hdf5File(const std::filesystem::path& path, Open how) : path_(path.string()) {
    prepare_library();
    if (how == Open::create) {
        const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
        H5Pset_libver_bounds(access.id(), H5F_LIBVER_V18, H5F_LIBVER_V18);
        file_ = Handle(H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose);
        if (file_.id() < 0) throw CannotCreate(fmt::format("{}: cannot be created", path_));
        return;
    }
    if (::access(path_.c_str(), how == Open::read ? R_OK : R_OK | W_OK) != 0) {
        throw NoInput(fmt::format("{}: {}", path_, std::strerror(errno)));
    }
    file_ = Handle(H5Fopen(path_.c_str(), how == Open::read ? H5F_ACC_RDONLY : H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    if (file_.id() < 0) throw Damaged(fmt::format("{}: not a readable HDF5 file", path_));
}

template <class T>
void Hdf5File::create(const std::string& name, const Shape& shape) {
    const Handle space = space_of(shape);
    const Handle links = make_missing_groups();
    const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_obj_track_times(creation.id(), 0);  // dates inside would make the files of equal runs differ
    const std::uint64_t size = product(shape);
    if (size > compressed_from) {
        std::vector<hsize_t> chunk = extents(shape);
        chunk[0] = std::max<hsize_t>(1, std::min(chunk[0], compressed_from * 16 * chunk[0] / size));
        H5Pset_chunk(creation.id(), static_cast<int>(chunk.size()), chunk.data());
        H5Pset_shuffle(creation.id());
        H5Pset_deflate(creation.id(), compression_level);
    }
    checked(H5Dcreate2(file_.id(), name.c_str(), native_type<T>(), space.id(), links.id(), creation.id(), H5P_DEFAULT),
            H5Dclose, path_, "creating " + name);
}

template <class T>
void Hdf5File::write(const std::string& name, std::span<const T> values, const Shape& shape) {
    if (values.size() != product(shape))
        throw std::logic_error(fmt::format("{}: {} has the wrong length", path_, name));
    create<T>(name, shape);
    if (values.empty()) return;
    const Handle data = checked(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Dclose, path_, "opening " + name);
    check(H5Dwrite(data.id(), native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), path_,
          "writing " + name);
}

template <class T>
void Hdf5File::write_rows(const std::string& name, std::uint64_t first, std::span<const T> values) {
    if (values.empty()) return;
    const Handle data = checked(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Dclose, path_, "opening " + name);
    const Handle space(H5Dget_space(data.id()), H5Sclose);
    std::vector<hsize_t> block = extents(shape(name)), start(block.size(), 0);
    const std::uint64_t of_row = product(Shape(block.begin() + 1, block.end())), rows = values.size() / of_row;
    if (rows * of_row != values.size() || first + rows > block[0])
        throw std::logic_error(fmt::format("{}: {} does not hold these rows", path_, name));
    start[0] = first;
    block[0] = rows;
    const Handle memory(H5Screate_simple(static_cast<int>(block.size()), block.data(), nullptr), H5Sclose);
    H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, block.data(), nullptr);
    check(H5Dwrite(data.id(), native_type<T>(), memory.id(), space.id(), H5P_DEFAULT, values.data()), path_,
          "writing " + name);
}

void Hdf5File::write_text(const std::string& name, std::string_view text) {
    const Handle type = text_type(text.size());
    const Handle space = space_of({});
    const Handle links = make_missing_groups();
    const Handle data =
        checked(H5Dcreate2(file_.id(), name.c_str(), type.id(), space.id(), links.id(), H5P_DEFAULT, H5P_DEFAULT),
                H5Dclose, path_, "creating " + name);
    const std::string padded(text.empty() ? std::string_view("\0", 1) : text);
    check(H5Dwrite(data.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()), path_, "writing " + name);
}

template <class T>
void Hdf5File::append(const std::string& name, std::span<const T> values, const Shape& shape) {
    if (values.size() != product(shape))
        throw std::logic_error(fmt::format("{}: {} has the wrong length", path_, name));
    std::vector<hsize_t> slab{1};
    slab.insert(slab.end(), shape.begin(), shape.end());
    const int rank = static_cast<int>(slab.size());
    if (!has(name)) {
        std::vector<hsize_t> none = slab, unlimited = slab, chunk = slab;
        none[0] = 0;
        unlimited[0] = H5S_UNLIMITED;
        chunk[0] = std::max<hsize_t>(1, 256 / std::max<std::size_t>(1, values.size()));
        const Handle space(H5Screate_simple(rank, none.data(), unlimited.data()), H5Sclose);
        const Handle links = make_missing_groups();
        const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
        H5Pset_obj_track_times(creation.id(), 0);
        H5Pset_chunk(creation.id(), rank, chunk.data());
        if (values.size() > compressed_from) {
            H5Pset_shuffle(creation.id());
            H5Pset_deflate(creation.id(), compression_level);
        }
        checked(
            H5Dcreate2(file_.id(), name.c_str(), native_type<T>(), space.id(), links.id(), creation.id(), H5P_DEFAULT),
            H5Dclose, path_, "creating " + name);
    }
    const Handle data = checked(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Dclose, path_, "opening " + name);
    std::vector<hsize_t> size(slab.size());
    {
        const Handle space(H5Dget_space(data.id()), H5Sclose);
        H5Sget_simple_extent_dims(space.id(), size.data(), nullptr);
    }
    std::vector<hsize_t> start(slab.size(), 0);
    start[0] = size[0]++;
    check(H5Dset_extent(data.id(), size.data()), path_, "extending " + name);
    const Handle space(H5Dget_space(data.id()), H5Sclose);
    const Handle memory(H5Screate_simple(rank, slab.data(), nullptr), H5Sclose);
    H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, slab.data(), nullptr);
    check(H5Dwrite(data.id(), native_type<T>(), memory.id(), space.id(), H5P_DEFAULT, values.data()), path_,
          "writing " + name);
}

namespace {

void write_attribute(hid_t file, const std::string& path, const std::string& object, const std::string& name,
                     hid_t type, const Shape& shape, const void* value) {
    const Handle target = checked(H5Oopen(file, object.c_str(), H5P_DEFAULT), H5Oclose, path, "opening " + object);
    const Handle space = space_of(shape);
    if (H5Aexists(target.id(), name.c_str()) > 0) H5Adelete(target.id(), name.c_str());
    const Handle attribute = checked(H5Acreate2(target.id(), name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                                     H5Aclose, path, "creating attribute " + name);
    check(H5Awrite(attribute.id(), type, value), path, "writing attribute " + name);
}

}  // namespace

void Hdf5File::attribute(const std::string& object, const std::string& name, std::string_view text) {
    const std::string padded(text.empty() ? std::string_view("\0", 1) : text);
    write_attribute(file_.id(), path_, object, name, text_type(text.size()).id(), {}, padded.data());
}
void Hdf5File::attribute(const std::string& object, const std::string& name, double value) {
    write_attribute(file_.id(), path_, object, name, H5T_NATIVE_DOUBLE, {}, &value);
}
void Hdf5File::attribute(const std::string& object, const std::string& name, std::int64_t value) {
    write_attribute(file_.id(), path_, object, name, H5T_NATIVE_INT64, {}, &value);
}
void Hdf5File::attribute(const std::string& object, const std::string& name, std::span<const std::int32_t> values) {
    write_attribute(file_.id(), path_, object, name, H5T_NATIVE_INT32, {values.size()}, values.data());
}
void Hdf5File::attribute(const std::string& object, const std::string& name, const std::vector<std::string>& texts) {
    std::size_t longest = 1;
    for (const std::string& text : texts) longest = std::max(longest, text.size());
    std::string packed;
    for (std::string text : texts) packed += (text.resize(longest, '\0'), text);
    write_attribute(file_.id(), path_, object, name, text_type(longest).id(), {texts.size()}, packed.data());
}

void Hdf5File::make_group(const std::string& name) {
    if (has(name)) return;
    const Handle links = make_missing_groups();
    checked(H5Gcreate2(file_.id(), name.c_str(), links.id(), H5P_DEFAULT, H5P_DEFAULT), H5Gclose, path_,
            "creating " + name);
}

void Hdf5File::hard_link(const std::string& existing, const std::string& name) {
    const Handle links = make_missing_groups();
    check(H5Lcreate_hard(file_.id(), existing.c_str(), file_.id(), name.c_str(), links.id(), H5P_DEFAULT), path_,
          "linking " + name);
}

bool Hdf5File::has(const std::string& name) const {
    for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
        if (H5Lexists(file_.id(), name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
        if (end == std::string::npos) return true;
    }
}

namespace {

Handle open_for_reading(const Hdf5File& file, hid_t id, const std::string& path, const std::string& name) {
    if (!file.has(name)) throw Damaged(fmt::format("{}: has no dataset {}", path, name));
    Handle data(H5Dopen2(id, name.c_str(), H5P_DEFAULT), H5Dclose);
    if (data.id() < 0) throw Damaged(fmt::format("{}: {} is not a readable dataset", path, name));
    return data;
}

}  // namespace

Shape Hdf5File::shape(const std::string& name) const {
    const Handle data = open_for_reading(*this, file_.id(), path_, name);
    const Handle space(H5Dget_space(data.id()), H5Sclose);
    std::vector<hsize_t> size(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space.id())));
    H5Sget_simple_extent_dims(space.id(), size.data(), nullptr);
    return {size.begin(), size.end()};
}

template <class T>
std::vector<T> Hdf5File::read(const std::string& name) const {
    const Handle data = open_for_reading(*this, file_.id(), path_, name);
    std::vector<T> values(product(shape(name)));
    if (values.empty()) return values;
    if (H5Dread(data.id(), native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
        throw Damaged(fmt::format("{}: {} cannot be read as numbers", path_, name));
    }
    return values;
}

double Hdf5File::read_number(const std::string& name) const {
    const std::vector<double> value = read<double>(name);
    if (value.size() != 1) throw Damaged(fmt::format("{}: {} is not one number", path_, name));
    return value[0];
}

std::string Hdf5File::read_text(const std::string& name) const {
    const Handle data = open_for_reading(*this, file_.id(), path_, name);
    const Handle type(H5Dget_type(data.id()), H5Tclose);
    std::string text(H5Tget_size(type.id()), '\0');
    if (H5Dread(data.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0) {
        throw Damaged(fmt::format("{}: {} cannot be read as text", path_, name));
    }
    return text.substr(0, text.find('\0'));
}

namespace {

Handle open_attribute(hid_t file, const std::string& path, const std::string& object, const std::string& name) {
    Handle attribute(H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    if (attribute.id() < 0) throw Damaged(fmt::format("{}: {} has no attribute {}", path, object, name));
    return attribute;
}

}  // namespace

double Hdf5File::read_number_attribute(const std::string& object, const std::string& name) const {
    const Handle attribute = open_attribute(file_.id(), path_, object, name);
    double value = 0.0;
    if (H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, &value) < 0) {
        throw Damaged(fmt::format("{}: attribute {} of {} is not a number", path_, name, object));
    }
    return value;
}

std::string Hdf5File::read_text_attribute(const std::string& object, const std::string& name) const {
    const Handle attribute = open_attribute(file_.id(), path_, object, name);
    const Handle type(H5Aget_type(attribute.id()), H5Tclose);
    std::string text(H5Tget_size(type.id()), '\0');
    if (H5Aread(attribute.id(), type.id(), text.data()) < 0) {
        throw Damaged(fmt::format("{}: attribute {} of {} cannot be read", path_, name, object));
    }
    return text.substr(0, text.find('\0'));
}

void Hdf5File::flush() { check(H5Fflush(file_.id(), H5F_SCOPE_GLOBAL), path_, "writing to disk"); }

void Hdf5File::close() {
    flush();
    Handle closing = std::move(file_);
}

template void Hdf5File::write(const std::string&, std::span<const double>, const Shape&);
template void Hdf5File::write(const std::string&, std::span<const float>, const Shape&);
template void Hdf5File::write(const std::string&, std::span<const std::int32_t>, const Shape&);
template void Hdf5File::write(const std::string&, std::span<const std::int64_t>, const Shape&);
template void Hdf5File::write(const std::string&, std::span<const std::uint64_t>, const Shape&);
template void Hdf5File::create<double>(const std::string&, const Shape&);
template void Hdf5File::create<std::int64_t>(const std::string&, const Shape&);
template void Hdf5File::write_rows(const std::string&, std::uint64_t, std::span<const double>);
template void Hdf5File::write_rows(const std::string&, std::uint64_t, std::span<const std::int64_t>);
template void Hdf5File::append(const std::string&, std::span<const double>, const Shape&);
template void Hdf5File::append(const std::string&, std::span<const float>, const Shape&);
template void Hdf5File::append(const std::string&, std::span<const std::int32_t>, const Shape&);
template void Hdf5File::append(const std::string&, std::span<const std::int64_t>, const Shape&);
template void Hdf5File::append(const std::string&, std::span<const std::uint64_t>, const Shape&);
template std::vector<double> Hdf5File::read(const std::string&) const;
template std::vector<float> Hdf5File::read(const std::string&) const;
template std::vector<std::int32_t> Hdf5File::read(const std::string&) const;
template std::vector<std::int64_t> Hdf5File::read(const std::string&) const;
template std::vector<std::uint64_t> Hdf5File::read(const std::string&) const;

}  // namespace shaken::files
