// SPDX-License-Identifier: MIT
// A file that only grows: records of doubles, each of a kind, for what a run lets go of while it goes on. A checkpoint
// keeps the length that was safe on the disk when it was written; what a killed process left behind that is cut off.
// Layout in docs/formats.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

namespace shaken::files {

class RecordLog {
  public:
    /// Makes the file, or opens it and cuts it back to `length` bytes, a length that sync() once gave; 0: empty.
    /// Throws CannotCreate, or Damaged where the file is shorter than that.
    RecordLog(const std::filesystem::path& path, std::uint64_t length);
    RecordLog(const RecordLog&) = delete;
    RecordLog& operator=(const RecordLog&) = delete;
    ~RecordLog();

    /// Throws WriteFailed.
    void append(std::uint64_t kind, std::span<const double> values);
    /// All that has been appended survives the death of the process and of the machine; the length of the file, bytes.
    /// Throws WriteFailed.
    std::uint64_t sync();

  private:
    void write_out();
    std::string path_;
    int descriptor_ = -1;
    std::uint64_t length_ = 0;  // with what waits in memory
    std::string waiting_;
};

/// Reads the first `length` bytes of a log, record by record, with the memory of one.
class RecordReader {
  public:
    /// Throws NoInput or Damaged.
    RecordReader(const std::filesystem::path& path, std::uint64_t length);

    /// Goes on to the next record; false at the end. Throws Damaged where it is not what was appended.
    bool next();
    std::uint64_t kind() const { return kind_; }
    std::uint64_t count() const { return count_; }
    /// Of this record. Throws Damaged where the checksum does not match.
    const std::vector<double>& values();

  private:
    void go_to(std::uint64_t place);
    std::string path_;
    std::ifstream file_;
    std::uint64_t length_, at_ = 0, stands_at_ = 0;  // bytes; at_: where the next record begins
    std::uint64_t kind_ = 0, count_ = 0, checksum_ = 0;
    std::vector<double> values_;
    bool is_read_ = false;
};

}  // namespace shaken::files
