// SPDX-License-Identifier: MIT
// The oscillating plate, z_p(t) = A (1 - cos 2 pi f t): lowest (0) at ft = 0, highest (2A) at ft = 0.5.
// Units: length sigma, time sqrt(sigma/g), so accelerations are in g.
#pragma once

#include <numbers>

#include "scene/elementary.hpp"

namespace shaken::scene {

struct PlateMotion {
    double amplitude = 0.0;  // A, in sigma
    double frequency = 1.0;  // f, in sqrt(g/sigma)

    /// From the peak acceleration over gravity, Gamma = 4 pi^2 f^2 A.
    static PlateMotion from_acceleration(double peak_acceleration, double frequency) {
        const double omega = 2.0 * std::numbers::pi * frequency;
        return {peak_acceleration / (omega * omega), frequency};
    }

    double angular_frequency() const { return 2.0 * std::numbers::pi * frequency; }
    double period() const { return 1.0 / frequency; }
    double peak_acceleration() const { return amplitude * angular_frequency() * angular_frequency(); }

    double position(double t) const { return amplitude * (1.0 - sine_cosine_of_turns(frequency * t).cosine); }
    double velocity(double t) const {
        return amplitude * angular_frequency() * sine_cosine_of_turns(frequency * t).sine;
    }
    double acceleration(double t) const { return peak_acceleration() * sine_cosine_of_turns(frequency * t).cosine; }
};

}  // namespace shaken::scene
