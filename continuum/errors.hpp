// SPDX-License-Identifier: MIT
// What can go wrong in a run of the continuum. A wrong name in a scene is a scene::SceneError, not one of these.
#pragma once

#include <stdexcept>
#include <string>

namespace shaken::continuum {

/// The state can not be advanced (not a number, the step fell below its limit, the floors hold too much of the mass).
/// The message says where (cell, height), when (cycle, time within it) and what was found. The state of the solver
/// is the last one that was sound, so that a checkpoint of it can be written.
struct RunFailed : std::runtime_error {
    RunFailed(const std::string& message, double when) : std::runtime_error(message), time(when) {}
    double time;  // of that state, in the cycle
};

}  // namespace shaken::continuum
