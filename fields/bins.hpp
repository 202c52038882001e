// SPDX-License-Identifier: MIT
// Equal bins along the height above the plate.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace shaken::fields {

struct Bins {
    double lower = 0.0;  // lower edge of bin 0, in sigma above the plate
    double width = 1.0;
    std::int64_t count = 0;

    double edge(std::int64_t i) const { return lower + width * static_cast<double>(i); }
    double centre(std::int64_t i) const { return lower + width * (static_cast<double>(i) + 0.5); }
    double upper() const { return edge(count); }
    /// Bin of a height, which may lie outside [0, count).
    std::int64_t index(double height) const { return static_cast<std::int64_t>(std::floor((height - lower) / width)); }
    bool contains(std::int64_t i) const { return i >= 0 && i < count; }
};

}  // namespace shaken::fields
