// SPDX-License-Identifier: MIT
#include "compare/layer.hpp"

namespace shaken::compare {

namespace {

/// Height at which the line through the volume fractions at two bin centres crosses the threshold.
double crossing(const fields::Profile& profile, std::int64_t outside, std::int64_t inside, double threshold) {
    const double nu_outside = profile.volume_fraction(outside);
    const double nu_inside = profile.volume_fraction(inside);
    const double share = (threshold - nu_outside) / (nu_inside - nu_outside);
    const fields::Bins& bins = profile.bins;
    return bins.centre(outside) + share * (bins.centre(inside) - bins.centre(outside));
}

}  // namespace

std::optional<Layer> find_layer(const fields::Profile& profile, double threshold) {
    const std::int64_t count = profile.bins.count;
    Layer layer;
    while (layer.first_bin < count && !(profile.volume_fraction(layer.first_bin) > threshold)) ++layer.first_bin;
    if (layer.first_bin == count) return std::nullopt;
    layer.last_bin = count - 1;
    while (!(profile.volume_fraction(layer.last_bin) > threshold)) --layer.last_bin;

    layer.lower =
        layer.first_bin == 0 ? profile.bins.lower : crossing(profile, layer.first_bin - 1, layer.first_bin, threshold);
    layer.upper = layer.last_bin == count - 1 ? profile.bins.upper()
                                              : crossing(profile, layer.last_bin + 1, layer.last_bin, threshold);
    return layer;
}

}  // namespace shaken::compare
