// SPDX-License-Identifier: MIT
// A plan: what both engines should be told for a wished error or time, what it costs here, and which error is from
// what. Errors are shares of z_cm, rms over twenty phases.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plan/trials.hpp"
#include "plan/wish.hpp"
#include "scene/scene.hpp"

namespace shaken::plan {

struct ContinuumPlan {
    int dimension = 1;
    std::string scheme;
    double spacing = 0.0, spacing_horizontal = 0.0, lid = 0.0;
    std::int64_t settle = 0, average = 2;
    std::int64_t settle_of_trial = 0;  // whatever the wish
    double seconds = 0.0, bytes = 0.0;
    double grid = 0.0;     // error of spacing and step together, cfl held
    double columns = 0.0;  // of the horizontal spacing
    double lid_error = 0.0;
    double start = 0.0;    // what is left of the initial state
    double scatter = 0.0;  // where the flow does not come back after two cycles
    double floor = 0.0;    // least error of the scheme in the measured table
    Profile together{};    // grid, lid and start with their signs: parts may cancel
    double error() const;
};

struct MdPlan {
    std::int64_t particles = 0;
    double box_x = 0.0, box_y = 0.0;
    std::int64_t settle = 0, average = 10, seeds = 1;
    double seconds = 0.0, bytes = 0.0;
    double statistics = 0.0;   // standard error of the mean over all seeds
    double uncertainty = 0.0;  // of it, relative: the trial's cycles are few
    double start = 0.0;
    double cell = 0.0;   // of a cell smaller than the scene's
    double drift = 0.0;  // where the trial's end lies elsewhere
    bool small_cell_may_collapse = false;
    double error() const;
};

/// Why a value was chosen, with what was measured.
struct Reason {
    std::string key, value, words;
};

struct Proposal {
    Wish wish;
    double aimed = 0.0;  // error that both engines were planned for
    ContinuumPlan continuum;
    MdPlan md;
    std::vector<Reason> reasons;
    std::vector<std::string> settings;  // section.key=value, on top of the given scene
    double trial_seconds = 0.0;
};

/// Throws CannotPlan for a wish that cannot be met and for scenes that are not shaken layers.
Proposal propose(const scene::Scene& scene, const Wish& wish);

}  // namespace shaken::plan
