// SPDX-License-Identifier: MIT
// The mean of independent samples and its standard error.
#pragma once

#include <cmath>
#include <vector>

struct Estimate {
    double value, error;
};

inline Estimate mean_of(const std::vector<double>& samples) {
    double sum = 0.0, square = 0.0;
    for (const double s : samples) sum += s;
    const double count = static_cast<double>(samples.size()), mean = sum / count;
    for (const double s : samples) square += (s - mean) * (s - mean);
    return {mean, std::sqrt(square / (count - 1.0) / count)};
}
