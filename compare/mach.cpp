// SPDX-License-Identifier: MIT
#include "compare/mach.hpp"

namespace shaken::compare {

double mach_number(const fields::Profile& profile, std::size_t bin, const Medium& medium) {
    if (!(profile.density[bin] > 0.0) || !(profile.temperature[bin] > 0.0)) return std::nan("");
    const double c =
        medium.sound_speed(profile.volume_fraction(static_cast<std::int64_t>(bin)), profile.temperature[bin]);
    if (!std::isfinite(c) || c <= 0.0) return std::nan("");
    return std::abs(profile.velocity[bin] - profile.plate_velocity) / c;
}

std::vector<double> mach_numbers(const fields::Profile& profile, const Medium& medium) {
    std::vector<double> mach(profile.density.size());
    for (std::size_t i = 0; i < mach.size(); ++i) mach[i] = mach_number(profile, i, medium);
    return mach;
}

double mean_free_path(const fields::Profile& profile, std::size_t bin, const Medium& medium) {
    return profile.density[bin] > 0.0 ? medium.mean_free_path(profile.density[bin]) : std::nan("");
}

MaximumMach maximum_mach(const fields::Profile& profile, const std::vector<double>& mach, const Layer& layer) {
    MaximumMach best;
    for (std::int64_t i = layer.first_bin; i <= layer.last_bin; ++i) {
        const double value = mach[static_cast<std::size_t>(i)];
        if (std::isnan(value) || value <= best.value) continue;
        best = {value, profile.bins.centre(i)};
    }
    return best;
}

}  // namespace shaken::compare
