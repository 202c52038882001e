// SPDX-License-Identifier: MIT
// The layer: where the volume fraction exceeds 4 % of random close packing (Bougie 2004, section 4.2).
#pragma once

#include <cstdint>
#include <optional>

#include "fields/profile.hpp"

namespace shaken::compare {

/// 0.04 nu_max with nu_max = 0.65.
inline constexpr double layer_volume_fraction = 0.04 * 0.65;

struct Layer {
    double lower = 0.0;  // edges above the plate, sigma; between bin centres by linear interpolation
    double upper = 0.0;
    std::int64_t first_bin = 0;  // outermost bins above the threshold
    std::int64_t last_bin = 0;
};

/// Outermost crossings of the threshold: spheres packed against the plate stand in planes, with empty bins between,
/// which must not cut the layer. None where no bin is above it.
std::optional<Layer> find_layer(const fields::Profile& profile, double threshold = layer_volume_fraction);

}  // namespace shaken::compare
