// SPDX-License-Identifier: MIT
// Weights of one step of exponential time differencing with two stages (Cox and Matthews 2002, equations 20 to 22) for
//   da/dt = rate a + N(a) + noise,
// whose linear part is exact, and of the noise gathered in that step, whose variance is exact too.
#pragma once

#include <cmath>

namespace shaken::swift_hohenberg {

struct ExponentialStep {
    double decay;         // e^x, x = rate * step
    double first;         // step (e^x - 1)/x: weight of N at the start
    double second;        // step (e^x - 1 - x)/x^2: weight of what N has changed by
    double noise_spread;  // (integral of e^(2 rate s) over the step)^(1/2)

    ExponentialStep(double rate, double step) {
        const double x = rate * step;
        decay = std::exp(x);
        first = step * divided_difference(x);
        // Cancellation leaves 1e-16/x^2 of the closed form; below 0.1 the series is exact to round-off.
        double series = 0.0;
        for (int n = 12; n >= 0; --n) series = (1.0 + x * series) / (n + 2.0);
        second = step * (std::abs(x) < 0.1 ? series : (std::expm1(x) - x) / (x * x));
        noise_spread = std::sqrt(step * divided_difference(2.0 * x));
    }

  private:
    static double divided_difference(double x) { return x == 0.0 ? 1.0 : std::expm1(x) / x; }
};

}  // namespace shaken::swift_hohenberg
