// SPDX-License-Identifier: MIT
// Mach number and mean free path of a profile, from the equation of state the scene names.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "compare/layer.hpp"
#include "fields/profile.hpp"

namespace shaken::compare {

/// What a profile is made of, as far as the comparison needs it.
struct Medium {
    std::function<double(double volume_fraction, double temperature)> sound_speed;  // sqrt(g sigma)
    std::function<double(double density)> mean_free_path;                           // sigma
};

/// Ma = |u_z - u_plate| / c in a bin (Bougie 2004, section 4.5); NaN where the bin is empty, has no temperature,
/// or is packed beyond what the equation of state knows (c not finite).
double mach_number(const fields::Profile& profile, std::size_t bin, const Medium& medium);
std::vector<double> mach_numbers(const fields::Profile& profile, const Medium& medium);

/// lambda in a bin, sigma; NaN where the bin is empty.
double mean_free_path(const fields::Profile& profile, std::size_t bin, const Medium& medium);

struct MaximumMach {
    double value = std::nan("");
    double height = std::nan("");  // above the plate
};

/// Greatest Mach number in the bins of the layer; the dilute gas outside does not count.
MaximumMach maximum_mach(const fields::Profile& profile, const std::vector<double>& mach, const Layer& layer);

}  // namespace shaken::compare
