// SPDX-License-Identifier: MIT
#include "md/sort_in_space.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace shaken::md {

namespace {

/// Spreads the lowest 21 bits so that two zeros stand between neighbours.
std::uint64_t spread(std::uint64_t bits) {
    bits &= 0x1fffff;
    bits = (bits | bits << 32) & 0x1f00000000ffff;
    bits = (bits | bits << 16) & 0x1f0000ff0000ff;
    bits = (bits | bits << 8) & 0x100f00f00f00f00f;
    bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
    return (bits | bits << 2) & 0x1249249249249249;
}

std::uint64_t cell(double coordinate) {
    constexpr std::int64_t below = 1 << 10;  // room for coordinates under zero
    return static_cast<std::uint64_t>(
        std::max<std::int64_t>(0, static_cast<std::int64_t>(std::floor(coordinate)) + below));
}

}  // namespace

void sort_in_space(std::span<Particle> particles) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order(particles.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        const Particle& p = particles[i];
        order[i] = {spread(cell(p.x)) | spread(cell(p.y)) << 1 | spread(cell(p.z)) << 2, i};
    }
    std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
        return a.first != b.first ? a.first < b.first : particles[a.second].id < particles[b.second].id;
    });
    const std::vector<Particle> before(particles.begin(), particles.end());
    for (std::size_t k = 0; k < order.size(); ++k) particles[k] = before[order[k].second];
}

}  // namespace shaken::md
