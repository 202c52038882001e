// SPDX-License-Identifier: MIT
// `shaken run`: both engines at once, a child process each, then the comparison and the report.
#pragma once

#include "app/options.hpp"

namespace shaken::app {

int run_both(const EngineOptions& options);

}  // namespace shaken::app
