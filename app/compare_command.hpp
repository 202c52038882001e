// SPDX-License-Identifier: MIT
// `shaken compare DIR` and `shaken report DIR`: what both engines left in a run folder becomes numbers and pictures.
#pragma once

#include <filesystem>
#include <vector>

namespace shaken::app {

struct CompareOptions {
    std::filesystem::path folder;           // where compare.h5 and summary.json go; made if it is not there
    std::vector<std::filesystem::path> md;  // run folders to average over; none: `folder` itself
    std::filesystem::path continuum;        // empty: `folder` itself
    bool first_cycle = false;               // of runs from a file: the first cycle of each, from where it began
};

/// Reads md.h5 and continuum.h5, writes compare.h5 and summary.json, prints the numbers. Several MD runs are averaged:
/// they and the continuum's may differ in seeds, start, length and [continuum], and the MD runs must be independent
/// (compare/independence.hpp), else files::Damaged. The sound speed is that of the continuum's scene. Throws
/// files::NoInput where an engine's file is missing.
int run_compare(const CompareOptions& options);

/// Draws figures/ and report.html; exit_code::stopped where a signal ends that. Throws files::NoInput where compare.h5
/// is missing.
int run_report(const std::filesystem::path& folder);

}  // namespace shaken::app
