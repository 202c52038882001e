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

Spread spread(const Heights& heights, std::size_t first) {
    const std::size_t cycles = heights.size() - std::min(first, heights.size());
    if (cycles < 6) return {};
    Spread found;
    found.block = std::max<std::size_t>(2, cycles / 16 * 2);
    found.blocks = cycles / found.block;
    first = heights.size() - found.blocks * found.block;
    const auto block = [&](std::size_t b) {
        return mean(heights, first + b * found.block, first + (b + 1) * found.block);
    };
    const auto blocks = static_cast<double>(found.blocks);
    const auto offset = [&](std::size_t b) { return static_cast<double>(b) - 0.5 * (blocks - 1.0); };
    Profile average{}, slope{};
    for (std::size_t b = 0; b < found.blocks; ++b) {
        const Profile one = block(b);
        for (std::size_t p = 0; p < phases; ++p) {
            average[p] += one[p] / blocks;
            slope[p] += 12.0 * offset(b) * one[p] / (blocks * (blocks * blocks - 1.0));
        }
    }
    double sum = 0.0;
    for (std::size_t b = 0; b < found.blocks; ++b) {
        Profile line = average;
        for (std::size_t p = 0; p < phases; ++p) line[p] += slope[p] * offset(b);
        const double off = difference(block(b), line);
        sum += off * off;
    }
    found.value = std::sqrt(sum / (blocks - 2.0) * static_cast<double>(found.block));
    found.uncertainty = 1.0 / std::sqrt(2.0 * (blocks - 2.0));
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
