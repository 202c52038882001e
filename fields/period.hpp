// SPDX-License-Identifier: MIT
// The period of a layer in cycles of the plate: 1, 2 or 4, from z_cm of every cycle at every phase. A perfectly
// inelastic body on the plate lands every other cycle above Gamma = sqrt(pi^2 + 4) = 3.72, and so does a layer.
// A series z_c alternates where gamma of the least-squares fit z_c = alpha + beta c + gamma (-1)^c
//   - is more than five standard errors from zero. They allow for memory: a layer of period one that is near doubling
//     swings for some cycles before it forgets, as (-rho)^c. rho is estimated, and granted to be from 0.5 to 0.8;
//   - is above half a diameter: such swings of a layer are smaller but in the smallest boxes;
//   - does not fade: the second half of the series has at least half of the first's (a continuum that still settles
//     alternates, less and less).
// Each sampled phase is asked; one that alternates is enough. Period four: what every other cycle is alternates.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fields/height_maps.hpp"

namespace shaken::fields {

inline constexpr double least_alternation = 0.5;  // |gamma|, sigma
inline constexpr double least_standard_errors = 5.0;
inline constexpr double least_lasting = 0.5;  // of the first half
/// Fewer cycles that show no alternation may hide one.
inline constexpr std::int64_t cycles_to_tell = 10;

/// gamma of a series (sigma), positive where its first cycle is the higher; how many standard errors it is from zero;
/// the ratio of its second half to its first.
struct Alternation {
    double height = 0.0, standard_errors = 0.0, lasting = 0.0;
    bool is_significant() const;
};
/// Of fewer than eight cycles nothing is significant.
Alternation alternation_of(std::span<const double> series);

/// heights: (cycles, phases), NaN where not sampled. Empty: too few cycles to tell, and none of what they show is
/// significant.
std::optional<int> period_of(const std::vector<double>& heights, std::int64_t phases);

/// Whether odd cycles (1, 3, ...) are the higher in the mean over all phases. By this rule the flow that comes first in
/// a period of two is chosen by the layer, not by when averaging began.
bool odd_cycles_are_higher(const std::vector<double>& heights, std::int64_t phases);

/// Share of the area whose own alternation is significant and opposite to that of the larger part, at the phase where
/// most of it is, over cycles from `first_cycle` on. Standing waves at half the frequency of the plate have one too:
/// crests and troughs change places every cycle.
double opposite_share(const HeightMaps& maps, std::int64_t first_cycle);

}  // namespace shaken::fields
