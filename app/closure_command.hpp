// SPDX-License-Identifier: MIT
// `shaken closure`: what a closure says of a gas, as a table or as JSON; without a name the closures there are.
#pragma once

#include <string>
#include <vector>

namespace shaken::app {

struct ClosureOptions {
    std::string name;  // empty: the list
    std::string pair_correlation = "goldshtein";
    std::vector<double> volume_fractions;
    double temperature = 1.0;  // g sigma
    double restitution = 1.0;  // constant
    bool json = false;
};

/// Throws UsageError for a name that is in no list, saying the nearest, and for numbers that no gas has.
int run_closure(const ClosureOptions& options);

}  // namespace shaken::app
