// SPDX-License-Identifier: MIT
// One implicit step of diffusion in a column: the tridiagonal system
//     (c_i + d_i + u_{i+1}) x_i - u_i x_{i-1} - d_{i+1} x_{i+1} = r_i,      i = 0 .. n-1,  x_{-1} = x_n = 0,
// c the capacities; what passes the face below cell i is u_i x_{i-1} up and d_i x_i down (d_0 and u_n: to the walls, 0
// where nothing passes). For diffusion alone u = d = w, the coupling.
// Eliminated from both ends towards the middle: half the latency of Thomas's algorithm, and a mirrored column gives
// mirrored bits. Only sums, products and quotients of positive numbers: no cancellation however large u/c is.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace shaken::continuum {

/// u and d of the faces.
struct Couplings {
    const double *up, *down;
};

/// n >= 2. Each row of `values` holds an r on entry and its x on return; `ratio` is scratch of length n. Several right
/// sides of one matrix share its divisions.
template <std::size_t rows>
inline void solve_diffusion(std::int64_t n, const double* capacity, const Couplings& coupling,
                            const std::array<double*, rows>& values, double* ratio) {
    const double *up = coupling.up, *down = coupling.down;
    const std::int64_t pairs = (n - 1) / 2;  // cells eliminated from each end
    double below = down[0], above = up[n];   // what the eliminated cells add to the next one's capacity
    std::array<double, rows> from_below{}, from_above{};
    for (std::int64_t k = 0; k < pairs; ++k) {
        const std::int64_t i = k, j = n - 1 - k;
        const double lower = capacity[i] + below, upper = capacity[j] + above;
        const double lower_inverse = 1.0 / (lower + up[i + 1]), upper_inverse = 1.0 / (upper + down[j]);
        for (std::size_t r = 0; r < rows; ++r) {
            values[r][i] = from_below[r] = (values[r][i] + up[i] * from_below[r]) * lower_inverse;
            values[r][j] = from_above[r] = (values[r][j] + down[j + 1] * from_above[r]) * upper_inverse;
        }
        ratio[i] = down[i + 1] * lower_inverse;
        ratio[j] = up[j] * upper_inverse;
        below = ratio[i] * lower;
        above = ratio[j] * upper;
    }
    const std::int64_t i = pairs, j = n - 1 - pairs;
    const double lower = capacity[i] + below, upper = capacity[j] + above;
    for (std::size_t r = 0; r < rows; ++r) {
        const double inflow_below = up[i] * from_below[r], inflow_above = down[j + 1] * from_above[r];
        if (i == j) {
            values[r][i] = (values[r][i] + (inflow_below + inflow_above)) / (capacity[i] + (below + above));
        } else {
            const double lower_value = values[r][i] + inflow_below, upper_value = values[r][j] + inflow_above;
            const double inverse = 1.0 / (lower * upper + (down[j] * lower + up[j] * upper));
            values[r][i] = (lower_value * (upper + down[j]) + down[j] * upper_value) * inverse;
            values[r][j] = (upper_value * (lower + up[j]) + up[j] * lower_value) * inverse;
        }
        from_below[r] = values[r][i];
        from_above[r] = values[r][j];
    }
    for (std::int64_t k = pairs - 1; k >= 0; --k) {
        const std::int64_t lowest = k, highest = n - 1 - k;
        for (std::size_t r = 0; r < rows; ++r) {
            values[r][lowest] = from_below[r] = values[r][lowest] + ratio[lowest] * from_below[r];
            values[r][highest] = from_above[r] = values[r][highest] + ratio[highest] * from_above[r];
        }
    }
}

inline void solve_diffusion(std::int64_t n, const double* capacity, const Couplings& coupling, double* values,
                            double* ratio) {
    solve_diffusion(n, capacity, coupling, std::array{values}, ratio);
}

/// The same in a ring: x_{-1} = x_{n-1}, x_n = x_0, u_0 = u_n and d_0 = d_n. What the two end cells take from each
/// other is moved to the right-hand side and found from the two columns of the inverse that belong to it.
inline void solve_periodic_diffusion(std::int64_t n, const double* capacity, const Couplings& coupling, double* values,
                                     double* ratio, double* of_first, double* of_last) {
    for (std::int64_t i = 0; i < n; ++i) of_first[i] = of_last[i] = 0.0;
    of_first[0] = coupling.up[0];
    of_last[n - 1] = coupling.down[0];
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
