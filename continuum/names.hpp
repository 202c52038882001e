// SPDX-License-Identifier: MIT
// What the keys of [continuum] that are chosen by name can be.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace shaken::continuum {

/// Key and the names it may have, in the order of the lists that hold them.
std::vector<std::pair<std::string, std::vector<std::string>>> known_names();

}  // namespace shaken::continuum
