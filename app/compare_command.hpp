// SPDX-License-Identifier: MIT
// `shaken compare DIR` and `shaken report DIR`: what both engines left in a run folder becomes numbers and pictures.
#pragma once

#include <filesystem>

namespace shaken::app {

/// Reads md.h5 and continuum.h5, writes compare.h5 and summary.json, prints the numbers. Throws files::NoInput where an
/// engine's file is missing.
int run_compare(const std::filesystem::path& folder);

/// Draws figures/ and report.html. Throws files::NoInput where compare.h5 is missing.
int run_report(const std::filesystem::path& folder);

}  // namespace shaken::app
