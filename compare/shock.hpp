// SPDX-License-Identifier: MIT
// The shock at one phase (Bougie 2004, section 4.4.1): the region in which T falls from its maximum at the top of the
// compressed part (near the plate) to the minimum at the bottom of the undisturbed part (still falling towards it).
//
//   z |        .  undisturbed, Ma > 1 towards the plate
//     |     .
//     |    .          <- foot: minimum of T
//     |      . .      <- location: steepest fall of T
//     |           .   <- top: maximum of T
//     |         .  compressed, Ma < 1
//     +---------------- T
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compare/layer.hpp"
#include "compare/mach.hpp"
#include "fields/profile.hpp"

namespace shaken::compare {

struct Shock {
    double top = 0.0;  // heights above the plate, sigma; all between the bins by a parabola through three
    double foot = 0.0;
    double location = 0.0;
    double temperature_top = 0.0;  // g sigma
    double temperature_foot = 0.0;
    double mach_above = 0.0;           // in the bin of the foot
    double mach_below = 0.0;           // in the bin of the top
    double mean_free_path = 0.0;       // at the location, sigma
    double mean_free_path_foot = 0.0;  // it varies across the shock: at the foot it is longer
    bool inside_layer = false;         // top and foot both lie in bins of the layer

    double steepest_slope = 0.0;  // of T at the location, g, positive

    /// The source's width: from the maximum to the minimum of T.
    double width() const { return foot - top; }
    /// Width by the steepest slope, the usual one of shock waves in gases: the whole fall over the slope.
    double slope_width() const { return (temperature_top - temperature_foot) / steepest_slope; }
};

struct ShockCriteria {
    /// A bump smaller than this share of a fall does not end it, and a fall smaller than it, relative to its own
    /// maximum, is none: noise of T in a bin is about sqrt(2/3) over the root of the particles seen there, some
    /// percent at the layer's edge.
    double prominence = 0.10;
    /// Bins thinner than this share of the layer's threshold are not looked at: too few particles to have a
    /// temperature.
    double thinnest = 0.2;
    /// Slopes are of the line of least squares over this height, sigma: about a shock's width, so that the noise of
    /// single bins does not decide where the fall is steepest.
    double window = 2.0;
    /// Least ratio of the mean density below the location to that at the foot. Above 1 the part below is compressed.
    /// Before, it is a hot thin gas between the plate and the falling layer, and its upper edge no shock. 0: any.
    double compression = 1.0;
};

/// The shock in a profile: among the falls of T with height whose foot moves towards the plate at Ma > 1 and whose top
/// is subsonic, and that have a compressed part below, the one that falls furthest. None where there is no such fall.
/// `mach` as of mach_numbers().
std::optional<Shock> find_shock(const fields::Profile& profile, const Layer& layer, const std::vector<double>& mach,
                                const Medium& medium, const ShockCriteria& criteria = {});

}  // namespace shaken::compare
