// SPDX-License-Identifier: MIT
#include "md/uniform_system.hpp"

#include <cmath>
#include <numbers>

namespace shaken::md {

double UniformSystem::box_length() const {
    return scene::cube_root(static_cast<double>(particles) * std::numbers::pi / (6.0 * volume_fraction));
}

}  // namespace shaken::md
