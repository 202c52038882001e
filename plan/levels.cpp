// SPDX-License-Identifier: MIT
#include "plan/levels.hpp"

#include <algorithm>
#include <cmath>

namespace shaken::plan {

Profile sum_of(Profile a, const Profile& b) {
    for (std::size_t p = 0; p < phases; ++p) a[p] += b[p];
    return a;
}

void tell_errors(std::vector<Level>& levels, double order) {
    if (levels.size() < 2) return;
    Level& finest = levels.back();
    finest.deviation = deviation(levels[levels.size() - 2].profile, finest.profile);
    for (double& d : finest.deviation) d /= std::pow(2.0, order) - 1.0;
    finest.error = root_mean_square(finest.deviation);
    for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
        levels[k].deviation = sum_of(deviation(levels[k].profile, finest.profile), finest.deviation);
        levels[k].error = root_mean_square(levels[k].deviation);
    }
}

Profile deviation_at(const std::vector<Level>& levels, double spacing, double error) {
    const auto nearer = [&](const Level& a, const Level& b) {
        return std::abs(std::log(a.spacing / spacing)) < std::abs(std::log(b.spacing / spacing));
    };
    const Level& nearest = *std::min_element(levels.begin(), levels.end(), nearer);
    Profile scaled = nearest.deviation;
    for (double& d : scaled) d *= nearest.error > 0.0 ? error / nearest.error : 0.0;
    return scaled;
}

double interpolate(const std::vector<Level>& levels, double spacing, double Level::*quantity, double order) {
    if (levels.size() == 1 || spacing <= levels.back().spacing)
        return levels.back().*quantity * std::pow(spacing / levels.back().spacing, order);
    std::size_t k = 0;
    while (k + 2 < levels.size() && levels[k + 1].spacing > spacing) ++k;
    const double share = std::log(spacing / levels[k].spacing) / std::log(levels[k + 1].spacing / levels[k].spacing);
    return levels[k].*quantity * std::pow(levels[k + 1].*quantity / (levels[k].*quantity), share);
}

}  // namespace shaken::plan
