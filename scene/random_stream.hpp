// SPDX-License-Identifier: MIT
// Random numbers that are the same on every machine: std::mt19937_64, whose output the standard fixes, and transforms
// of our own, because the distributions of the standard library differ between implementations.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "scene/elementary.hpp"

namespace shaken::scene {

class RandomStream {
  public:
    explicit RandomStream(std::uint64_t seed) : engine_(seed) {}

    /// In [0, 1), 53 random bits.
    double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    double uniform(double lower, double upper) { return lower + (upper - lower) * uniform(); }
    /// In [0, count); the bias of the plain product, count / 2^53, is far below any statistics.
    std::size_t index(std::size_t count) { return static_cast<std::size_t>(uniform() * static_cast<double>(count)); }
    /// Mean 0, variance 1 (Box and Muller 1958).
    double normal() {
        const double radius = std::sqrt(-2.0 * natural_logarithm(1.0 - uniform()));
        return radius * sine_cosine_of_turns(uniform()).cosine;
    }

  private:
    std::mt19937_64 engine_;
};

}  // namespace shaken::scene
