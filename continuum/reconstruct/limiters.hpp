// SPDX-License-Identifier: MIT
// Slope limiters for MUSCL: the slope of a cell from the steps below (a) and above (b) it. All are symmetric, odd,
// zero at extrema, and total variation diminishing (Sweby 1984); at smooth extrema they fall to first order. In a
// strong shock (shock.hpp) `in_shock` of the slope is left: van Leer's and the mean lie between the smaller step and
// twice that, where behind a strong shock all above the smaller rings (docs/numerics.md).
#pragma once

#include <cmath>
#include <string_view>

#include "continuum/choice.hpp"
#include "continuum/flux/wave_speeds.hpp"

namespace shaken::continuum {

/// +1 or -1 where both have that sign, 0 where they differ.
[[gnu::always_inline]] inline double common_sign(double a, double b) {
    return 0.5 * (std::copysign(1.0, a) + std::copysign(1.0, b));
}

/// The smaller step. Roe 1986.
struct LimiterMinmod {
    static constexpr std::string_view name = "minmod";
    static constexpr std::string_view words = "the smaller step; Roe 1986";
    static constexpr double in_shock = 1.0;
    [[gnu::always_inline]] static double slope(double a, double b) {
        return common_sign(a, b) * smaller(std::abs(a), std::abs(b));
    }
};

/// The harmonic mean. van Leer 1974.
struct LimiterVanLeer {
    static constexpr std::string_view name = "van_leer";
    static constexpr std::string_view words = "the harmonic mean; van Leer 1974";
    static constexpr double in_shock = 0.5;
    [[gnu::always_inline]] static double slope(double a, double b) {
        const double product = a * b;
        // The quotient stands outside the choice, or the loop around it does not vectorise.
        const double above = product > 0.0 ? 2.0 * product : 0.0;
        const double below = product > 0.0 ? a + b : 1.0;
        return above / below;
    }
};

/// Monotonized central: the mean, at most twice the smaller step. van Leer 1977.
struct LimiterMonotonizedCentral {
    static constexpr std::string_view name = "mc";
    static constexpr std::string_view words =
        "monotonized central: the mean, at most twice the smaller step; van Leer 1977";
    static constexpr double in_shock = 0.5;
    [[gnu::always_inline]] static double slope(double a, double b) {
        const double least = smaller(0.5 * std::abs(a + b), 2.0 * smaller(std::abs(a), std::abs(b)));
        return common_sign(a, b) * least;
    }
};

/// No slope: first order, Godunov's method.
struct LimiterFirstOrder {
    static constexpr std::string_view name = "first_order";
    static constexpr std::string_view words = "no slope: Godunov's method";
    static constexpr double in_shock = 1.0;
    [[gnu::always_inline]] static double slope(double, double) { return 0.0; }
};

using Limiters = Choices<LimiterVanLeer, LimiterMinmod, LimiterMonotonizedCentral, LimiterFirstOrder>;

}  // namespace shaken::continuum
