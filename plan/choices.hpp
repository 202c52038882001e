// SPDX-License-Identifier: MIT
// The least that keeps an error: lid, settling, grid of the continuum, cycles and seeds of the MD, from trials.
#pragma once

#include "plan/proposal.hpp"
#include "plan/trials.hpp"

namespace shaken::plan {

/// Least grid, lid and cycles whose parts are each below half the error. Throws CannotPlan where no grid runs.
ContinuumPlan choose_continuum(Trials& trials, double error);

/// Cycles and seeds after the settling time of the continuum's column, whose start they forget alike.
MdPlan choose_md(Trials& trials, const ContinuumPlan& continuum, double error);

/// The scene as planned so far, for trials of its MD and of its grid.
scene::Scene planned_scene(const scene::Scene& scene, const ContinuumPlan& continuum);

}  // namespace shaken::plan
