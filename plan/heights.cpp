// SPDX-License-Identifier: MIT
#include "plan/heights.hpp"

#include <algorithm>
#include <cmath>

namespace shaken::plan {

Profile mean(const Heights& heights, std::size_t first, std::size_t last) {
    Profile sum{};
    last = std::min(last, heights.size());
    for (std::size_t c = first; c < last; ++c)
        for (std::size_t p = 0; p < phases; ++p) sum[p] += heights[c][p];
    for (double& value : sum) value /= static_cast<double>(last - first);
    return sum;
}

Profile deviation(const Profile& a, const Profile& b) {
    Profile found;
    for (std::size_t p = 0; p < phases; ++p) found[p] = a[p] / b[p] - 1.0;
    return found;
}

double root_mean_square(const Profile& deviation) {
    double sum = 0.0;
    for (const double d : deviation) sum += d * d;
    return std::sqrt(sum / static_cast<double>(phases));
}

double difference(const Profile& a, const Profile& b) { return root_mean_square(deviation(a, b)); }

namespace {

constexpr std::size_t least_blocks = 8;

/// An even number of cycles, so that both halves of a layer of two periods count alike.
Profile end_of(const Heights& heights) {
    const std::size_t quarter = std::max<std::size_t>(2, heights.size() / 8 * 2);
    return mean(heights, heights.size() - quarter, heights.size());
}

}  // namespace

std::size_t settling_time(const Heights& heights, double tolerance) {
    const Profile end = end_of(heights);
    std::size_t settled = heights.size() / 4 * 3;
    while (settled > 0 && difference(mean(heights, settled - 1, settled + 1), end) <= tolerance) --settled;
    return settled;
}

Profile left_of_start(const Heights& heights, std::size_t settle, std::size_t cycles) {
    const std::size_t whole = heights.size(), first = std::min(settle, whole - 2);
    const std::size_t last = std::min(first + std::max<std::size_t>(2, cycles), whole);
    const double counted = static_cast<double>(last - first) / static_cast<double>(std::max(cycles, last - first));
    Profile left = deviation(mean(heights, first, last), end_of(heights));
    for (double& d : left) d *= counted;
    return left;
}

namespace {

/// From half the mean square step between neighbouring blocks of so many cycles at the record's end.
Spread of_blocks(const Heights& heights, std::size_t cycles, std::size_t block) {
    Spread found;
    found.block = block;
    found.blocks = cycles / block;
    const std::size_t first = heights.size() - found.blocks * block;
    double sum = 0.0;
    for (std::size_t b = first; b + 2 * block <= heights.size(); b += block) {
        const double step = difference(mean(heights, b + block, b + 2 * block), mean(heights, b, b + block));
        sum += 0.5 * step * step;
    }
    const double steps = static_cast<double>(found.blocks - 1);
    found.value = std::sqrt(sum / steps * static_cast<double>(block));
    found.uncertainty = std::sqrt(0.75 / steps);  // neighbouring steps share a block
    return found;
}

}  // namespace

Spread spread(const Heights& heights, std::size_t first) {
    const std::size_t cycles = heights.size() - std::min(first, heights.size());
    if (cycles < 4) return {};
    Spread found = of_blocks(heights, cycles, 2);
    for (std::size_t block = 4; cycles / block >= least_blocks; block *= 2) {
        const Spread longer = of_blocks(heights, cycles, block);
        if (longer.value > found.value * (1.0 + 2.0 * longer.uncertainty)) found = longer;
    }
    return found;
}

double drift(const Heights& heights, std::size_t settle, std::size_t cycles, double spread) {
    const std::size_t whole = heights.size(), third = whole / 6 * 2;
    if (whole < 12 || settle + 2 > whole) return 0.0;
    const std::size_t last = std::min(settle + cycles, whole);
    const double off = difference(mean(heights, settle, last), mean(heights, whole - third, whole));
    const double explained =
        spread * std::sqrt(1.0 / static_cast<double>(last - settle) + 1.0 / static_cast<double>(third));
    return off > 3.0 * explained ? off : 0.0;
}

}  // namespace shaken::plan
