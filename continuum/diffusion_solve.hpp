// SPDX-License-Identifier: MIT
// One implicit step of diffusion in a column: the tridiagonal system
//     (c_i + w_i + w_{i+1}) x_i - w_i x_{i-1} - w_{i+1} x_{i+1} = r_i,      i = 0 .. n-1,  x_{-1} = x_n = 0,
// c the capacities, w_i the coupling across the face below cell i (w_0 and w_n: to the walls, 0 where nothing passes).
// Eliminated from both ends towards the middle: half the latency of Thomas's algorithm, and a mirrored column gives
// mirrored bits. Only sums, products and quotients of positive numbers: no cancellation however large w/c is.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace shaken::continuum {

/// n >= 2. Each row of `values` holds an r on entry and its x on return; `ratio` is scratch of length n. Several right
/// sides of one matrix share its divisions.
template <std::size_t rows>
inline void solve_diffusion(std::int64_t n, const double* capacity, const double* coupling,
                            const std::array<double*, rows>& values, double* ratio) {
    const std::int64_t pairs = (n - 1) / 2;           // cells eliminated from each end
    double below = coupling[0], above = coupling[n];  // what the eliminated cells add to the next one's capacity
    std::array<double, rows> from_below{}, from_above{};
    for (std::int64_t k = 0; k < pairs; ++k) {
        const std::int64_t i = k, j = n - 1 - k;
        const double lower = capacity[i] + below, upper = capacity[j] + above;
        const double lower_inverse = 1.0 / (lower + coupling[i + 1]), upper_inverse = 1.0 / (upper + coupling[j]);
        for (std::size_t r = 0; r < rows; ++r) {
            values[r][i] = from_below[r] = (values[r][i] + coupling[i] * from_below[r]) * lower_inverse;
            values[r][j] = from_above[r] = (values[r][j] + coupling[j + 1] * from_above[r]) * upper_inverse;
        }
        ratio[i] = coupling[i + 1] * lower_inverse;
        ratio[j] = coupling[j] * upper_inverse;
        below = ratio[i] * lower;
        above = ratio[j] * upper;
    }
    const std::int64_t i = pairs, j = n - 1 - pairs;
    const double lower = capacity[i] + below, upper = capacity[j] + above, w = coupling[j];
    for (std::size_t r = 0; r < rows; ++r) {
        const double inflow_below = coupling[i] * from_below[r], inflow_above = coupling[j + 1] * from_above[r];
        if (i == j) {
            values[r][i] = (values[r][i] + (inflow_below + inflow_above)) / (capacity[i] + (below + above));
        } else {
            const double lower_value = values[r][i] + inflow_below, upper_value = values[r][j] + inflow_above;
            const double inverse = 1.0 / (lower * upper + w * (lower + upper));
            values[r][i] = (lower_value * (upper + w) + w * upper_value) * inverse;
            values[r][j] = (upper_value * (lower + w) + w * lower_value) * inverse;
        }
        from_below[r] = values[r][i];
        from_above[r] = values[r][j];
    }
    for (std::int64_t k = pairs - 1; k >= 0; --k) {
        const std::int64_t down = k, up = n - 1 - k;
        for (std::size_t r = 0; r < rows; ++r) {
            values[r][down] = from_below[r] = values[r][down] + ratio[down] * from_below[r];
            values[r][up] = from_above[r] = values[r][up] + ratio[up] * from_above[r];
        }
    }
}

inline void solve_diffusion(std::int64_t n, const double* capacity, const double* coupling, double* values,
                            double* ratio) {
    solve_diffusion(n, capacity, coupling, std::array{values}, ratio);
}

/// The same in a ring: x_{-1} = x_{n-1}, x_n = x_0 and w_0 = w_n. What the two end cells take from each other is moved
/// to the right-hand side and found from the two columns of the inverse that belong to it.
inline void solve_periodic_diffusion(std::int64_t n, const double* capacity, const double* coupling, double* values,
                                     double* ratio, double* of_first, double* of_last) {
    for (std::int64_t i = 0; i < n; ++i) of_first[i] = of_last[i] = 0.0;
    of_first[0] = of_last[n - 1] = coupling[0];
    solve_diffusion(n, capacity, coupling, values, ratio);
    solve_diffusion(n, capacity, coupling, of_first, ratio);
    solve_diffusion(n, capacity, coupling, of_last, ratio);
    // x = y + x_{n-1} of_first + x_0 of_last, taken at both ends.
    const double a = 1.0 - of_last[0], b = of_first[0], c = of_last[n - 1], d = 1.0 - of_first[n - 1];
    const double inverse = 1.0 / (a * d - b * c);
    const double first = (d * values[0] + b * values[n - 1]) * inverse;
    const double last = (a * values[n - 1] + c * values[0]) * inverse;
    for (std::int64_t i = 0; i < n; ++i) values[i] += last * of_first[i] + first * of_last[i];
}

}  // namespace shaken::continuum
