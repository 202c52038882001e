// SPDX-License-Identifier: MIT
#include "run/gas_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace shaken::run {

namespace {

constexpr std::size_t most_blocks = 100;

/// Of one interval between samples: integrals of T and of sqrt(T).
struct Elapsed {
    double heat = 0.0, speed = 0.0;
};

/// Exact where 1/sqrt(T) grows evenly, as it does while a gas cools by Haff's law.
Elapsed elapsed_between(double temperature, double later, double time) {
    const double one = std::sqrt(temperature), other = std::sqrt(later), ratio = one / other;
    return {time * one * other, time * (std::abs(ratio - 1.0) < 1e-6 ? 0.5 * (one + other)
                                                                     : other * std::log(ratio) / (1.0 - 1.0 / ratio))};
}

}  // namespace

GasBlocks gas_blocks(const fields::TimeSeries& series, std::size_t first, double particles) {
    GasBlocks blocks;
    if (series.rows() < first + 2) return blocks;
    const std::size_t last = series.rows() - 1;
    const auto at = [&](std::size_t row, const char* column) { return series.value(row, column); };
    // The total momentum is zero: 3 (N - 1) degrees of freedom hold 3 N T/2.
    const auto temperature = [&](std::size_t row) { return at(row, "temperature") * particles / (particles - 1.0); };
    std::vector<Elapsed> until{{}};  // sums from the first row to each
    for (std::size_t row = first; row < last; ++row) {
        const Elapsed one =
            elapsed_between(temperature(row), temperature(row + 1), series.time(row + 1) - series.time(row));
        until.push_back({until.back().heat + one.heat, until.back().speed + one.speed});
    }
    const double share = until.back().speed / static_cast<double>(std::min(last - first, most_blocks));
    std::size_t from = first;
    for (std::size_t row = first + 1; row <= last; ++row) {
        // Round-off must not put an end off. What is left over after the last share goes with the last block.
        const double due = until[row - first].speed - until[from - first].speed;
        const double left = until.back().speed - until[row - first].speed;
        if (row < last && (due < (1.0 - 1e-9) * share || left < 0.5 * share)) continue;
        const double heat = until[row - first].heat - until[from - first].heat;
        blocks.compressibility.push_back(1.0 + (at(row, "virial") - at(from, "virial")) / (3.0 * particles * heat));
        blocks.rate.push_back(2.0 * (at(row, "pair_collisions") - at(from, "pair_collisions")) / (particles * due));
        double shape = 0.0;
        for (std::size_t k = from + 1; k <= row; ++k) shape += at(k, "fourth_cumulant");
        blocks.cumulant.push_back(shape / static_cast<double>(row - from));
        blocks.cooling.push_back((1.0 / std::sqrt(at(row, "temperature")) - 1.0 / std::sqrt(at(from, "temperature"))) /
                                 (series.time(row) - series.time(from)));
        from = row;
    }
    return blocks;
}

}  // namespace shaken::run
