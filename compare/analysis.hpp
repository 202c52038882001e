// SPDX-License-Identifier: MIT
// Everything that is measured of one engine's run: profiles, layer, shock and Mach number at every phase, the shock's
// history, the centre of mass; and the same of parts of the cycles, from which standard errors follow.
// A layer of period two has two cycles, each averaged apart, and phases 0 <= ft < 2.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "compare/cycle_memory.hpp"
#include "compare/layout.hpp"
#include "compare/mach.hpp"
#include "compare/shock_history.hpp"
#include "fields/phase_moments.hpp"
#include "scene/plate_motion.hpp"

namespace shaken::compare {

/// One cycle, averaged over cycles, or two. All vectors have one entry a phase.
struct Analysis {
    std::vector<fields::Profile> profiles;
    std::vector<PhaseMeasures> measures;
    std::vector<double> centre_of_mass;                   // lab frame, sigma
    std::optional<ShockHistory> history, second_history;  // of the shock that forms in either cycle

    /// Whether the phase with this index lies in the life of a shock.
    bool follows(std::int64_t phase) const;
    bool follows_fully_formed(std::int64_t phase) const;
};

Analysis analyse(const fields::PhaseMoments& moments, const scene::PlateMotion& motion, const Medium& medium,
                 const Layout& layout = {}, const std::vector<bool>& kept_blocks = {});

/// A number and its standard error, NaN where unknown.
struct Estimate {
    double value = 0.0;
    double error = 0.0;
};

struct Measured {
    Analysis all;
    std::vector<Analysis> without_block;  // one for each block of cycles; empty if there is one block only
    Layout layout = {};
    CycleMemory memory = {};                     // its factor is in every error
    std::vector<std::vector<bool>> halves = {};  // of the blocks; an analysis of each
    std::vector<Analysis> of_halves = {};

    /// Any number that is a smooth function of means, with its jackknife error.
    Estimate estimate(const std::function<double(const Analysis&)>& number) const;
    /// Any number that moves in steps or jumps, with its error from halves of the blocks.
    Estimate estimate_from_halves(const std::function<double(const Analysis&)>& number) const;
};

/// Blocks of single cycles are taken in pairs where cycles are averaged apart.
Measured measure(const fields::PhaseMoments& moments, const scene::PlateMotion& motion, const Medium& medium,
                 const Layout& layout = {});

/// Values given at equal phases of a period, at `wanted` equal phases: picked where they coincide, linear between.
std::vector<double> at_equal_phases(const std::vector<double>& values, std::int64_t wanted);

/// Index of the phase nearest to ft, among `phases` equal ones over so many cycles.
std::size_t nearest_phase(double phase, std::size_t phases, std::int64_t cycles = 1);

}  // namespace shaken::compare
