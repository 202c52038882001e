// SPDX-License-Identifier: MIT
// What can go wrong with a file, one type a kind; app/ maps each to its exit code.
#pragma once

#include <stdexcept>

namespace shaken::files {

struct FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};
struct NoInput : FileError {
    using FileError::FileError;
};  // not there or not readable
struct Damaged : FileError {
    using FileError::FileError;
};  // there, and not what it should be
struct CannotCreate : FileError {
    using FileError::FileError;
};  // no permission, exists already
struct WriteFailed : FileError {
    using FileError::FileError;
};  // disk full, I/O error

}  // namespace shaken::files
