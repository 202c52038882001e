// SPDX-License-Identifier: MIT
// What is wished for on the command line: an error or a time.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

namespace shaken::plan {

/// A wish that cannot be meant or met; says what is possible.
struct CannotPlan : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// "1%" or "0.01", both 0.01. Throws CannotPlan outside (0, 0.5].
double share_of(const std::string& text);

/// A share in per cent, in two digits.
std::string per_cent(double share);

/// Exactly one of the two.
struct Wish {
    std::optional<double> error;    // share of z_cm, of each engine
    std::optional<double> seconds;  // of processor time, both engines together
};

}  // namespace shaken::plan
