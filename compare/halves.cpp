// SPDX-License-Identifier: MIT
#include "compare/halves.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "scene/random_stream.hpp"

namespace shaken::compare {

namespace {

constexpr int most_pairs = 20;          // the error scatters by 15 % for that, by 24 % for ten blocks
constexpr double share_outside = 0.16;  // on either side of one standard error
constexpr std::uint64_t seed = 1;       // so that a comparison made twice says the same

}  // namespace

std::vector<std::vector<bool>> halves_of_blocks(std::size_t blocks) {
    std::vector<std::vector<bool>> halves;
    if (blocks < 2) return halves;
    scene::RandomStream random(seed);
    std::vector<std::size_t> order(blocks);
    std::iota(order.begin(), order.end(), 0);
    for (int pair = 0; pair < most_pairs; ++pair) {
        for (std::size_t i = blocks - 1; i > 0; --i) std::swap(order[i], order[random.index(i + 1)]);
        std::vector<bool> half(blocks);
        for (std::size_t i = 0; i < blocks / 2; ++i) half[order[i]] = true;
        if (std::find(halves.begin(), halves.end(), half) != halves.end()) continue;
        halves.push_back(half);
        half.flip();
        halves.push_back(half);
    }
    return halves;
}

double error_from_halves(std::span<const double> values, const std::vector<std::vector<bool>>& halves) {
    std::vector<double> known;
    for (const double x : values)
        if (std::isfinite(x)) known.push_back(x);
    if (2 * known.size() <= values.size()) return std::nan("");
    std::nth_element(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2), known.end());
    const double middle = known[known.size() / 2];
    std::vector<double> moved;  // as far as another run moves
    for (std::size_t h = 0; h < values.size(); ++h) {
        if (!std::isfinite(values[h])) continue;
        const auto kept = static_cast<double>(std::count(halves[h].begin(), halves[h].end(), true));
        const double left_out = static_cast<double>(halves[h].size()) - kept;
        moved.push_back(std::sqrt(kept / left_out) * (values[h] - middle));
    }
    std::sort(moved.begin(), moved.end());
    const auto outside = static_cast<std::size_t>(share_outside * static_cast<double>(moved.size()));
    return 0.5 * (moved[moved.size() - 1 - outside] - moved[outside]);
}

}  // namespace shaken::compare
