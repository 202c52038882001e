// SPDX-License-Identifier: MIT
// Everything that is measured of one engine's run: profiles, layer, shock and Mach number at every phase, the shock's
// history, the centre of mass; and the same with each block of cycles left out, from which standard errors follow.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "compare/mach.hpp"
#include "compare/shock_history.hpp"
#include "fields/phase_moments.hpp"
#include "scene/plate_motion.hpp"

namespace shaken::compare {

/// One cycle, averaged over cycles. All vectors have one entry a phase.
struct Analysis {
    std::vector<fields::Profile> profiles;
    std::vector<PhaseMeasures> measures;
    std::vector<double> centre_of_mass;  // lab frame, sigma
    std::optional<ShockHistory> history;
};

Analysis analyse(const fields::PhaseMoments& moments, const scene::PlateMotion& motion, const Medium& medium,
                 std::optional<std::int64_t> left_out_block = std::nullopt);

/// A number and its standard error, NaN where unknown.
struct Estimate {
    double value = 0.0;
    double error = 0.0;
};

struct Measured {
    Analysis all;
    std::vector<Analysis> without_block;  // one for each block of cycles; empty if there is one block only

    /// Any number that an analysis gives, with its jackknife error.
    Estimate estimate(const std::function<double(const Analysis&)>& number) const;
};

Measured measure(const fields::PhaseMoments& moments, const scene::PlateMotion& motion, const Medium& medium);

/// Values given at equal phases of a cycle, at `wanted` equal phases: picked where they coincide, linear between.
std::vector<double> at_equal_phases(const std::vector<double>& values, std::int64_t wanted);

/// Index of the phase nearest to ft, among `phases` equal ones.
std::size_t nearest_phase(double phase, std::size_t phases);

}  // namespace shaken::compare
