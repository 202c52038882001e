// SPDX-License-Identifier: MIT
// `shaken swift-hohenberg`: steady states of the noisy Swift-Hohenberg equation, measured as the engines' patterns are.
#pragma once

#include <cstdint>
#include <vector>

#include "swift_hohenberg/parameters.hpp"

namespace shaken::app {

struct SwiftHohenbergOptions {
    swift_hohenberg::Parameters parameters;
    std::vector<double> controls{0.0};
    std::int64_t settle = 8000, average = 2000;  // steps, the source's
};

/// One line of JSON for each control. Returns an exit code; throws UsageError for values out of range.
int run_swift_hohenberg(const SwiftHohenbergOptions& options);

}  // namespace shaken::app
