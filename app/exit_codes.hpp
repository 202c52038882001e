// SPDX-License-Identifier: MIT
// Exit codes of the command, after sysexits.h where it has one.
#pragma once

namespace shaken::app::exit_code {

inline constexpr int done = 0;
inline constexpr int run_failed = 1;      // not a number, overlap, stall
inline constexpr int usage = 2;           // the command line
inline constexpr int bad_input = 65;      // scene or data that cannot be accepted
inline constexpr int no_input = 66;       // no such file
inline constexpr int cannot_create = 73;  // no permission, folder not empty, in use
inline constexpr int write_failed = 74;   // disk full, I/O error
inline constexpr int stopped = 75;        // by a signal or the time limit; a checkpoint is there, resumable

}  // namespace shaken::app::exit_code
