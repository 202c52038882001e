// SPDX-License-Identifier: MIT
// Puts particles that are near each other in space near each other in memory.
#pragma once

#include <span>

#include "md/particle.hpp"

namespace shaken::md {

/// Orders along a Morton curve over cells of one diameter; ties by the particle's number. All at one time.
void sort_in_space(std::span<Particle> particles);

}  // namespace shaken::md
