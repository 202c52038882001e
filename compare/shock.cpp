// SPDX-License-Identifier: MIT
#include "compare/shock.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace shaken::compare {

namespace {

struct Fall {
    std::size_t top = 0, foot = 0;  // places in the list of usable bins
};

/// Every fall along a list of temperatures, bumps below the prominence ignored.
std::vector<Fall> find_falls(const std::vector<double>& temperature, double prominence) {
    std::vector<Fall> falls;
    if (temperature.empty()) return falls;
    std::size_t top = 0, foot = 0;
    const auto is_deep = [&] { return temperature[foot] < (1.0 - prominence) * temperature[top]; };
    for (std::size_t i = 1; i < temperature.size(); ++i) {
        const double drop = temperature[top] - temperature[foot];
        if (is_deep() && temperature[i] - temperature[foot] > prominence * drop) {
            falls.push_back({top, foot});
            top = foot = i;
        } else if (!is_deep() && temperature[i] >= temperature[top]) {
            top = foot = i;
        } else if (temperature[i] < temperature[foot]) {
            foot = i;
        }
    }
    if (is_deep()) falls.push_back({top, foot});
    return falls;
}

/// Offset from the middle one of three equidistant values to the extremum of the parabola through them, in steps;
/// 0 where the middle one is not an extremum.
double parabola_offset(double before, double middle, double after) {
    const double curvature = before - 2.0 * middle + after;
    if (curvature == 0.0) return 0.0;
    const double offset = 0.5 * (before - after) / curvature;
    return std::abs(offset) <= 0.5 ? offset : 0.0;
}

/// The bins that hold enough to have a temperature, from the plate upward, with heights and temperatures.
struct Usable {
    std::vector<std::size_t> bin;
    std::vector<double> height, temperature;

    Usable(const fields::Profile& profile, double thinnest) {
        for (std::int64_t i = 0; i < profile.bins.count; ++i) {
            const double t = profile.temperature[static_cast<std::size_t>(i)];
            if (!(profile.volume_fraction(i) > thinnest) || !(t > 0.0)) continue;
            bin.push_back(static_cast<std::size_t>(i));
            height.push_back(profile.bins.centre(i));
            temperature.push_back(t);
        }
    }
    bool has_both_neighbours(std::size_t i) const {
        return i > 0 && i + 1 < bin.size() && bin[i] - bin[i - 1] == 1 && bin[i + 1] - bin[i] == 1;
    }
};

/// Height of an extremum of T between the bins.
double extremum(const Usable& usable, std::size_t i, double bin_width) {
    if (!usable.has_both_neighbours(i)) return usable.height[i];
    const std::vector<double>& t = usable.temperature;
    return usable.height[i] + bin_width * parabola_offset(t[i - 1], t[i], t[i + 1]);
}

/// Slope of the straight line of least squares through the temperatures within half a window of a height.
double fitted_slope(const Usable& usable, double height, double half_window) {
    double count = 0.0, sum_z = 0.0, sum_t = 0.0, sum_zz = 0.0, sum_zt = 0.0;
    for (std::size_t i = 0; i < usable.height.size(); ++i) {
        const double z = usable.height[i] - height;
        if (std::abs(z) > half_window) continue;
        count += 1.0;
        sum_z += z;
        sum_t += usable.temperature[i];
        sum_zz += z * z;
        sum_zt += z * usable.temperature[i];
    }
    return (count * sum_zt - sum_z * sum_t) / (count * sum_zz - sum_z * sum_z);
}

struct Steepest {
    double height = 0.0;
    double slope = 0.0;  // of the fall, positive
};

/// Where T falls most steeply between top and foot; slopes live half way between bins.
Steepest steepest_fall(const Usable& usable, const Fall& fall, double bin_width, double window) {
    // At least the two bins on either side, whatever the round-off of their heights.
    const auto half_window = [&](std::size_t i) {
        return std::max(0.5 * window, 0.5 * (usable.height[i] - usable.height[i - 1])) + 1e-6 * bin_width;
    };
    std::vector<double> height, slope;
    for (std::size_t i = fall.top + 1; i <= fall.foot; ++i) {
        height.push_back(0.5 * (usable.height[i - 1] + usable.height[i]));
        slope.push_back(-fitted_slope(usable, height.back(), half_window(i)));
    }
    const auto k = static_cast<std::size_t>(std::max_element(slope.begin(), slope.end()) - slope.begin());
    Steepest steepest{height[k], slope[k]};
    if (k > 0 && k + 1 < slope.size()) {
        steepest.height += bin_width * parabola_offset(slope[k - 1], slope[k], slope[k + 1]);
    }
    return steepest;
}

/// Mean density from the layer's lower edge up to a height, at least of the lowest bin.
double density_below(const fields::Profile& profile, const Layer& layer, double height) {
    double sum = 0.0, count = 0.0;
    for (std::int64_t i = layer.first_bin; i <= layer.last_bin; ++i) {
        if (i > layer.first_bin && profile.bins.centre(i) > height) break;
        sum += profile.density[static_cast<std::size_t>(i)];
        count += 1.0;
    }
    return sum / count;
}

/// Density at a height, linear between bin centres.
double density_at(const fields::Profile& profile, double height) {
    const double position = (height - profile.bins.centre(0)) / profile.bins.width;
    const double last = static_cast<double>(profile.bins.count - 1);
    const double clamped = std::clamp(position, 0.0, last);
    const auto below = static_cast<std::size_t>(std::min(std::floor(clamped), std::max(last - 1.0, 0.0)));
    const std::size_t above = std::min(below + 1, profile.density.size() - 1);
    const double share = clamped - static_cast<double>(below);
    return (1.0 - share) * profile.density[below] + share * profile.density[above];
}

}  // namespace

std::optional<Shock> find_shock(const fields::Profile& profile, const Layer& layer, const std::vector<double>& mach,
                                const Medium& medium, const ShockCriteria& criteria) {
    const Usable usable(profile, criteria.thinnest * layer_volume_fraction);
    std::optional<Fall> best;
    Steepest steepest;
    double best_drop = 0.0;
    for (const Fall& fall : find_falls(usable.temperature, criteria.prominence)) {
        const std::size_t top = usable.bin[fall.top], foot = usable.bin[fall.foot];
        const double drop = profile.temperature[top] - profile.temperature[foot];
        const bool falls_towards_plate = profile.velocity[foot] < profile.plate_velocity;
        // A bin packed beyond the equation of state has no Mach number, and is as subsonic as can be.
        const bool crosses_sound = mach[foot] > 1.0 && !(mach[top] >= 1.0);
        if (!falls_towards_plate || !crosses_sound || drop <= best_drop) continue;
        const Steepest place = steepest_fall(usable, fall, profile.bins.width, criteria.window);
        if (density_below(profile, layer, place.height) < criteria.compression * profile.density[foot]) continue;
        best = fall;
        best_drop = drop;
        steepest = place;
    }
    if (!best) return std::nullopt;

    const std::size_t top = usable.bin[best->top], foot = usable.bin[best->foot];
    Shock shock;
    shock.top = extremum(usable, best->top, profile.bins.width);
    shock.foot = extremum(usable, best->foot, profile.bins.width);
    shock.location = steepest.height;
    shock.steepest_slope = steepest.slope;
    shock.temperature_top = profile.temperature[top];
    shock.temperature_foot = profile.temperature[foot];
    shock.mach_above = mach[foot];
    shock.mach_below = mach[top];
    shock.mean_free_path = medium.mean_free_path(density_at(profile, shock.location));
    shock.mean_free_path_foot = medium.mean_free_path(density_at(profile, shock.foot));
    shock.inside_layer =
        static_cast<std::int64_t>(top) >= layer.first_bin && static_cast<std::int64_t>(foot) <= layer.last_bin;
    return shock;
}

}  // namespace shaken::compare
