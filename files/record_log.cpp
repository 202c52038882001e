// SPDX-License-Identifier: MIT
// Layout (little endian): magic "SHKNLOG1", then for each record its kind (u64), number of values (u64), XXH3-64 of the
// values seeded with the kind (u64), values (f64).
#include "files/record_log.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <xxhash.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>

#include "files/errors.hpp"

namespace shaken::files {

namespace {

constexpr std::string_view magic = "SHKNLOG1";
constexpr std::size_t held_in_memory = 1 << 20;  // bytes
using Header = std::array<std::uint64_t, 3>;

std::uint64_t checksum(std::uint64_t kind, std::span<const double> values) {
    return XXH3_64bits_withSeed(values.data(), values.size_bytes(), kind);
}

}  // namespace

RecordLog::RecordLog(const std::filesystem::path& path, std::uint64_t length) : path_(path.string()) {
    const int fresh = length == 0 ? O_CREAT | O_TRUNC : 0;
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | fresh, 0644);
    if (descriptor_ < 0) {
        const std::string reason = std::strerror(errno);
        if (length > 0)
            throw Damaged(fmt::format("{}: cannot be opened, and a checkpoint needs it: {}", path_, reason));
        throw CannotCreate(fmt::format("{}: cannot be created: {}", path_, reason));
    }
    if (length == 0) {
        waiting_ = magic;
        length_ = magic.size();
        return;
    }
    const off_t there = ::lseek(descriptor_, 0, SEEK_END);
    if (there < static_cast<off_t>(length) || ::ftruncate(descriptor_, static_cast<off_t>(length)) != 0 ||
        ::lseek(descriptor_, 0, SEEK_END) != static_cast<off_t>(length)) {
        ::close(descriptor_);
        throw Damaged(fmt::format("{}: {} bytes, the checkpoint needs {}", path_, there, length));
    }
    length_ = length;
}

RecordLog::~RecordLog() { ::close(descriptor_); }

void RecordLog::append(std::uint64_t kind, std::span<const double> values) {
    const Header header{kind, values.size(), checksum(kind, values)};
    waiting_.append(reinterpret_cast<const char*>(header.data()), sizeof header);
    waiting_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    length_ += sizeof header + values.size_bytes();
    if (waiting_.size() >= held_in_memory) write_out();
}

void RecordLog::write_out() {
    for (std::string_view left = waiting_; !left.empty();) {
        const ssize_t written = ::write(descriptor_, left.data(), left.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) throw WriteFailed(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
        left.remove_prefix(static_cast<std::size_t>(written));
    }
    waiting_.clear();
    if (waiting_.capacity() > 2 * held_in_memory) waiting_.shrink_to_fit();  // after a frame
}

std::uint64_t RecordLog::sync() {
    write_out();
    if (::fsync(descriptor_) != 0)
        throw WriteFailed(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
    return length_;
}

RecordReader::RecordReader(const std::filesystem::path& path, std::uint64_t length)
    : path_(path.string()), file_(path, std::ios::binary | std::ios::ate), length_(length) {
    if (!file_) throw NoInput(fmt::format("{}: no such file, or not readable", path_));
    const auto there = static_cast<std::uint64_t>(file_.tellg());
    if (there < length_) throw Damaged(fmt::format("{}: {} bytes, the checkpoint needs {}", path_, there, length_));
    std::array<char, magic.size()> first{};
    file_.seekg(0);
    file_.read(first.data(), first.size());
    if (!file_ || std::string_view(first.data(), first.size()) != magic)
        throw Damaged(fmt::format("{}: not a log of this program (its first bytes differ)", path_));
    at_ = stands_at_ = magic.size();
}

void RecordReader::go_to(std::uint64_t place) {
    constexpr std::uint64_t near = 65536;  // read over: a seek throws the buffer away
    if (place < stands_at_ || place - stands_at_ > near)
        file_.seekg(static_cast<std::streamoff>(place));
    else
        file_.ignore(static_cast<std::streamsize>(place - stands_at_));
    stands_at_ = place;
}

bool RecordReader::next() {
    if (at_ == length_) return false;
    Header header{};
    go_to(at_);
    file_.read(reinterpret_cast<char*>(header.data()), sizeof header);
    stands_at_ = at_ + sizeof header;
    const std::uint64_t left = length_ - at_;
    if (!file_ || left < sizeof header || header[1] > (left - sizeof header) / sizeof(double))
        throw Damaged(fmt::format("{}: damaged log: a record runs past the end", path_));
    kind_ = header[0];
    count_ = header[1];
    checksum_ = header[2];
    at_ += sizeof header + count_ * sizeof(double);
    is_read_ = false;
    return true;
}

const std::vector<double>& RecordReader::values() {
    if (is_read_) return values_;
    is_read_ = true;
    values_.resize(count_);
    file_.read(reinterpret_cast<char*>(values_.data()), static_cast<std::streamsize>(count_ * sizeof(double)));
    stands_at_ += count_ * sizeof(double);
    if (!file_ || checksum(kind_, values_) != checksum_)
        throw Damaged(fmt::format("{}: damaged log: a checksum does not match its record", path_));
    return values_;
}

}  // namespace shaken::files
