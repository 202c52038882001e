// SPDX-License-Identifier: MIT
// Profiles and cycles with a shock whose place, width and speed are known.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "compare/mach.hpp"
#include "compare/shock_history.hpp"
#include "fields/phase_moments.hpp"
#include "fields/profile.hpp"
#include "scene/plate_motion.hpp"
#include "tests/support/normal.hpp"

using namespace shaken;

namespace synthetic {

/// An ideal gas, chi = 1: c^2 = 5 T / 3.
inline compare::Medium ideal_gas() {
    return {[](double, double temperature) { return std::sqrt(5.0 / 3.0 * temperature); },
            [](double density) { return std::sqrt(std::numbers::pi / 8.0) / (density * std::numbers::pi); }};
}

using support::Normal;

/// A layer between the plate and `layer_top`, split by a front: compressed, hot and at rest below, falling at `inflow`
/// and cold above. T rises with height on both sides, as in the shaken layer.
struct Front {
    double location = 6.0;
    double half_width = 0.7;  // of the tanh
    double layer_top = 15.0;
    double inflow = 8.0;

    double share_above(double z) const { return 0.5 * (1.0 + std::tanh((z - location) / half_width)); }
    double temperature(double z) const {
        const double undisturbed = 0.1 + 0.02 * std::exp(0.3 * (z - location));
        return (5.0 + 0.2 * z) * (1.0 - share_above(z)) + undisturbed;
    }
    double volume_fraction(double z) const {
        // Above the layer's top the front does not compress, so that the layer's edge stays where it is.
        if (z > layer_top) return 0.12 * std::exp(layer_top - z);
        return 0.4 * (1.0 - share_above(z)) + 0.12 * share_above(z);
    }
    double velocity(double z) const { return -inflow * share_above(z); }

    /// Place of the largest value of a function of height, by brute force on steps of 1e-4.
    template <class Function>
    static double place_of_maximum(double from, double to, Function f) {
        double best = from;
        for (double z = from; z <= to; z += 1e-4) {
            if (f(z) > f(best)) best = z;
        }
        return best;
    }
    double exact_top() const {
        return place_of_maximum(0.0, location, [&](double z) { return temperature(z); });
    }
    double exact_foot() const {
        return place_of_maximum(location, layer_top, [&](double z) { return -temperature(z); });
    }
    double exact_location() const {
        const double h = 1e-3;
        return place_of_maximum(exact_top(), exact_foot(),
                                [&](double z) { return temperature(z - h) - temperature(z + h); });
    }

    /// Values at the bins' centres, T and nu with relative normal noise.
    fields::Profile profile(const fields::Bins& bins, double noise = 0.0, std::uint64_t seed = 1) const {
        Normal normal(seed);
        fields::Profile p;
        p.bins = bins;
        p.plate_velocity = 3.0;
        for (std::int64_t i = 0; i < bins.count; ++i) {
            const double z = bins.centre(i);
            p.density.push_back(volume_fraction(z) * 6.0 / std::numbers::pi * (1.0 + noise * normal()));
            p.velocity.push_back(p.plate_velocity + velocity(z));
            p.temperature.push_back(temperature(z) * (1.0 + noise * normal()));
        }
        p.temperature_x = p.temperature_z = p.temperature;
        return p;
    }
};

/// The same layer with no front: T rises with height everywhere.
inline fields::Profile quiet_profile(const fields::Bins& bins, double noise = 0.0, std::uint64_t seed = 1) {
    Normal normal(seed);
    const Front shape{.location = -100.0};
    fields::Profile p = shape.profile(bins);
    for (std::int64_t i = 0; i < bins.count; ++i) {
        const double t = 0.05 * std::exp(0.1 * bins.centre(i)) * (1.0 + noise * normal());
        p.temperature[static_cast<std::size_t>(i)] = t;
    }
    return p;
}

inline std::vector<compare::PhaseMeasures> measure(std::vector<fields::Profile> profiles) {
    std::vector<compare::PhaseMeasures> measures;
    for (std::size_t k = 0; k < profiles.size(); ++k) {
        profiles[k].phase = static_cast<double>(k) / static_cast<double>(profiles.size());
        measures.push_back(compare::measure_phase(profiles[k], ideal_gas()));
    }
    return measures;
}

/// A front that runs up through a layer at rest on the plate; blocks of cycles differ by noise of velocity and z_cm.
inline fields::PhaseMoments run_with_front(std::int64_t blocks, double noise = 1.0) {
    const scene::PlateMotion motion{5.0, 0.1};
    fields::PhaseMoments moments(fields::Deposits::cells, 40, {0.0, 0.5, 80}, 1.0, blocks, blocks);
    for (std::int64_t cycle = 0; cycle < blocks; ++cycle) {
        Normal normal(static_cast<std::uint64_t>(cycle) + 1);
        for (std::int64_t phase = 0; phase < 40; ++phase) {
            const double ft = static_cast<double>(phase) / 40.0;
            const Front front{.location = ft < 0.2 ? -20.0 : 2.0 + 60.0 * (ft - 0.2)};
            const double plate = motion.velocity(ft * motion.period());
            moments.begin_sample(cycle, phase);
            for (int i = 0; i < 400; ++i) {
                const double z = 0.1 * i + 0.05;
                const double n = front.volume_fraction(z) * 6.0 / std::numbers::pi;
                moments.add_slab(z - 0.05, z + 0.05, n, {0.0, 0.0, plate + front.velocity(z) + 0.05 * noise * normal()},
                                 front.temperature(z));
            }
            moments.set_centre_of_mass(10.0 + 0.1 * noise * normal());
        }
    }
    return moments;
}

}  // namespace synthetic
