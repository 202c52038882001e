// SPDX-License-Identifier: MIT
// A sum over cells in an order of its own: eight partial sums, whatever the width of the machine's vectors. The order
// of a simd reduction follows that width, so its last bits would differ between builds of one program.
#pragma once

#include <cstdint>

namespace shaken::continuum {

inline double sum_in_lanes(const double* terms, std::int64_t count) {
    double lane[8] = {};
    std::int64_t first = 0;
    for (; first + 8 <= count; first += 8)
#pragma omp simd
        for (std::int64_t k = 0; k < 8; ++k) lane[k] += terms[first + k];
    for (std::int64_t k = 0; first + k < count; ++k) lane[k] += terms[first + k];
    return ((lane[0] + lane[4]) + (lane[2] + lane[6])) + ((lane[1] + lane[5]) + (lane[3] + lane[7]));
}

}  // namespace shaken::continuum
