// SPDX-License-Identifier: MIT
// Elementary functions whose bits no C library decides: additions, multiplications, divisions and square roots, which
// IEEE 754 rounds in one way. Those of <cmath> differ in the last bit between C libraries and between processors, and
// grains forget nothing: a run would end elsewhere. Errors are measured in tests/scene/elementary_tests.cpp.
// Series: sine, cosine, exp2 and arctangent by Taylor, log2 by that of the inverse hyperbolic tangent.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace shaken::scene {

struct SineCosine {
    double sine, cosine;
};

/// Sine and cosine of an angle in turns (1 is 2 pi), |turns| < 1e12; an ulp of 1 at most, exact at quarters.
[[gnu::always_inline]] inline SineCosine sine_cosine_of_turns(double turns) {
    constexpr double round_to_integer = 6755399441055744.0;  // 1.5 * 2^52: the sum has no bits below 1
    const double shifted = 4.0 * turns + round_to_integer;
    const double quarters = shifted - round_to_integer;
    const double x = 2.0 * std::numbers::pi * (turns - 0.25 * quarters), y = x * x;  // |x| <= pi/4
    const double sine =
        x + x * y *
                (-1.0 / 6 +
                 y * (1.0 / 120 +
                      y * (-1.0 / 5040 +
                           y * (1.0 / 362880 +
                                y * (-1.0 / 39916800 + y * (1.0 / 6227020800 + y * (-1.0 / 1307674368000 +
                                                                                    y * (1.0 / 355687428096000))))))));
    const double cosine =
        1.0 -
        y * (1.0 / 2 -
             y * (1.0 / 24 -
                  y * (1.0 / 720 - y * (1.0 / 40320 - y * (1.0 / 3628800 - y * (1.0 / 479001600 -
                                                                                y * (1.0 / 87178291200 -
                                                                                     y * (1.0 / 20922789888000))))))));
    const std::uint64_t quadrant = std::bit_cast<std::uint64_t>(shifted);
    const double first = quadrant & 1 ? cosine : sine, second = quadrant & 1 ? sine : cosine;
    return {quadrant & 2 ? -first : first, (quadrant + 1) & 2 ? -second : second};
}

/// Base-2 logarithm of a positive normal number; a large negative number for 0.
[[gnu::always_inline]] inline double fast_log2(double x) {
    constexpr std::uint64_t mantissa_bits = 0x000fffffffffffffULL;
    constexpr std::uint64_t one_exponent = 0x3ff0000000000000ULL;  // of 1.0
    constexpr std::uint64_t two_to_52 = 0x4330000000000000ULL;     // adding an integer to its bits adds it to 2^52
    constexpr std::uint64_t shift = 0x00095f619980c433ULL;         // (2 - sqrt(2)) * 2^52
    // Adding the shift carries into the exponent where the mantissa is above sqrt(2), so
    // that what is left lies in [sqrt(1/2), sqrt(2)).
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x) + shift;
    const double exponent = std::bit_cast<double>(two_to_52 | (bits >> 52)) - (4503599627370496.0 + 1023.0);
    const double mantissa = std::bit_cast<double>((bits & mantissa_bits) + one_exponent - shift);
    const double t = (mantissa - 1.0) / (mantissa + 1.0);
    const double s = t * t;
    const double series =
        1.0 + s * (1.0 / 3 +
                   s * (1.0 / 5 +
                        s * (1.0 / 7 +
                             s * (1.0 / 9 +
                                  s * (1.0 / 11 +
                                       s * (1.0 / 13 + s * (1.0 / 15 + s * (1.0 / 17 + s * (1.0 / 19 + s / 21)))))))));
    constexpr double two_over_ln2 = 2.8853900817779268;
    return exponent + two_over_ln2 * (t * series);
}

/// 2^y for -1022 < y < 1023.
[[gnu::always_inline]] inline double fast_exp2(double y) {
    constexpr double round_to_integer = 6755399441055744.0;  // 1.5 * 2^52: the sum has no bits below 1
    const double shifted = y + round_to_integer;
    const double r = (y - (shifted - round_to_integer)) * 0.69314718055994531;
    const double series =
        1.0 +
        r * (1.0 + r * (1.0 / 2 +
                        r * (1.0 / 6 +
                             r * (1.0 / 24 +
                                  r * (1.0 / 120 +
                                       r * (1.0 / 720 +
                                            r * (1.0 / 5040 +
                                                 r * (1.0 / 40320 +
                                                      r * (1.0 / 362880 +
                                                           r * (1.0 / 3628800 +
                                                                r * (1.0 / 39916800 + r * (1.0 / 479001600))))))))))));
    const std::uint64_t scale = (std::bit_cast<std::uint64_t>(shifted) + 1023) << 52;
    return series * std::bit_cast<double>(scale);
}

/// Of a positive normal number.
inline double natural_logarithm(double x) { return std::numbers::ln2 * fast_log2(x); }

/// e^x, x < 700; the value at -700, 1e-304, for what lies below. Relative error 1e-16 (2 + |x|).
inline double exponential(double x) { return fast_exp2(std::numbers::log2e * (x > -700.0 ? x : -700.0)); }

/// Of a positive normal number.
inline double cube_root(double x) {
    const double guess = fast_exp2(fast_log2(x) / 3.0);
    return guess - (guess * guess * guess - x) / (3.0 * guess * guess);
}

/// In [0, pi/2], of x in [0, 1].
inline double arc_sine(double x) {
    // tan(a/2) = tan(a)/(1 + sqrt(1 + tan^2 a)), from the sine at first and then from the tangent: an eighth of the
    // angle.
    double tangent = x / (1.0 + std::sqrt((1.0 - x) * (1.0 + x)));
    for (int halving = 0; halving < 2; ++halving) tangent = tangent / (1.0 + std::sqrt(1.0 + tangent * tangent));
    const double s = tangent * tangent;  // below 0.04
    const double series =
        1.0 -
        s * (1.0 / 3 -
             s * (1.0 / 5 -
                  s * (1.0 / 7 -
                       s * (1.0 / 9 - s * (1.0 / 11 - s * (1.0 / 13 - s * (1.0 / 15 - s * (1.0 / 17 - s / 19))))))));
    return 8.0 * tangent * series;
}

}  // namespace shaken::scene
