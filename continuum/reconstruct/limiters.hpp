// SPDX-License-Identifier: MIT
// Slope limiters for MUSCL: the slope of a cell from the steps below (a) and above (b) it. All are symmetric, odd,
// zero at extrema, and total variation diminishing (Sweby 1984); at smooth extrema they fall to first order.
#pragma once

#include <cmath>
#include <string_view>

#include "continuum/choice.hpp"
#include "continuum/flux/wave_speeds.hpp"

namespace continuum {

/// The smaller step. Roe 1986.
struct LimiterMinmod {
    static constexpr std::string_view name = "minmod";
    static double slope(double a, double b) {
        const double least = smaller(std::abs(a), std::abs(b));
        return a * b > 0.0 ? std::copysign(least, a) : 0.0;
    }
};

/// The harmonic mean. van Leer 1974.
struct LimiterVanLeer {
    static constexpr std::string_view name = "van_leer";
    static double slope(double a, double b) {
        const double product = a * b;
        return product > 0.0 ? 2.0 * product / (a + b) : 0.0;
    }
};

/// Monotonized central: the mean, at most twice the smaller step. van Leer 1977.
struct LimiterMonotonizedCentral {
    static constexpr std::string_view name = "mc";
    static double slope(double a, double b) {
        const double least = smaller(0.5 * std::abs(a + b), 2.0 * smaller(std::abs(a), std::abs(b)));
        return a * b > 0.0 ? std::copysign(least, a) : 0.0;
    }
};

/// No slope: first order, Godunov's method.
struct LimiterFirstOrder {
    static constexpr std::string_view name = "first_order";
    static double slope(double, double) { return 0.0; }
};

using Limiters = Choices<LimiterVanLeer, LimiterMinmod, LimiterMonotonizedCentral, LimiterFirstOrder>;

}  // namespace continuum
