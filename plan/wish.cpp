// SPDX-License-Identifier: MIT
#include "plan/wish.hpp"

#include <fmt/format.h>

#include <charconv>

namespace shaken::plan {

double share_of(const std::string& text) {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [rest, failure] = std::from_chars(text.data(), end, value);
    std::string unit(rest, end);
    if (!unit.empty() && unit.front() == ' ') unit.erase(0, 1);
    const double share = unit == "%" ? 0.01 * value : value;
    if (failure != std::errc{} || !(unit.empty() || unit == "%") || !(share > 0.0 && share <= 0.5)) {
        throw CannotPlan(fmt::format("--error {}: give a share of z_cm above 0 and up to 50%, as 1% or as 0.01", text));
    }
    return share;
}

std::string per_cent(double share) { return fmt::format("{:.2g} %", 100.0 * share); }

}  // namespace shaken::plan
