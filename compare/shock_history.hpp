// SPDX-License-Identifier: MIT
// The shock's life over one cycle of the plate: when it forms, when it leaves the layer, how fast it goes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "compare/layer.hpp"
#include "compare/mach.hpp"
#include "compare/shock.hpp"
#include "fields/profile.hpp"

namespace shaken::compare {

/// What is measured of one profile.
struct PhaseMeasures {
    double phase = 0.0;
    std::optional<Layer> layer;
    std::optional<Shock> shock;
    MaximumMach maximum_mach;
};

PhaseMeasures measure_phase(const fields::Profile& profile, const Medium& medium, const ShockCriteria& criteria = {});

struct ShockHistory {
    std::int64_t first = 0, last = 0;     // phase indices; last may exceed their number by less than once round
    std::int64_t first_fully_formed = 0;  // phase index, as the two above
    double formation_phase = 0.0;         // first phase with a shock inside the layer; resolved to one phase
    double leaving_phase = 0.0;           // its location passes the layer's upper edge; interpolated between phases
    double formation_location = 0.0;      // above the plate, sigma
    double leaving_location = 0.0;
    double mean_speed = 0.0;  // in the frame of the plate, between the two, sqrt(g sigma)
    /// First phase from which on the top has left the plate: it is nearer to the location than to the layer's lower
    /// edge, so that T rises with height in most of the compressed part. Until then T falls all the way from the plate.
    double fully_formed_phase = 0.0;
    double fully_formed_speed =
        0.0;                     // mean from then to leaving; unlike mean_speed it needs no location near the plate
    double fitted_speed = 0.0;   // slope of the line of least squares through the locations from then to leaving
    double approach_mach = 0.0;  // greatest Mach number in the layer at the last phase before formation

    std::vector<std::int64_t> passed_over;  // phase indices in between at which noise outdid the shock

    /// Whether a phase index lies between formation and leaving, round the cycle, and is not passed over.
    bool follows(std::int64_t phase, std::int64_t phases) const { return lies_from(first, phase, phases); }
    bool follows_fully_formed(std::int64_t phase, std::int64_t phases) const {
        return lies_from(first_fully_formed, phase, phases);
    }

  private:
    bool lies_from(std::int64_t begin, std::int64_t phase, std::int64_t phases) const {
        const auto same = [&](std::int64_t noisy) { return (noisy - phase) % phases == 0; };
        return ((phase - begin) % phases + phases) % phases <= last - begin &&
               std::none_of(passed_over.begin(), passed_over.end(), same);
    }
};

/// Follows the longest run of phases with a shock, circularly: a cycle has no preferred start. Where `phases` span
/// `cycles` of them, the longest that begins in cycle `in_cycle`; phases ft then count from the first. Gaps up to a
/// hundredth of a cycle are bridged, since noise may hide a shock at one phase, or outdo it elsewhere: a location
/// further from the last one than the fastest wave could have gone is passed over. Frequency in sqrt(g/sigma). None
/// where no run of at least 3 % of a cycle lies inside the layer. leaving_phase may exceed the number of cycles; it is
/// NaN, and so are the speeds, where the location never passes the upper edge.
std::optional<ShockHistory> follow_shock(const std::vector<PhaseMeasures>& phases, double frequency,
                                         std::int64_t cycles = 1, std::int64_t in_cycle = 0);

}  // namespace shaken::compare
