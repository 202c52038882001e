// SPDX-License-Identifier: MIT
// May two runs be compared or averaged? What they may differ in follows from what a key shapes and who owns it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/scene.hpp"

namespace shaken::scene {

struct Difference {
    std::string key;         // "section.key"
    std::string one, other;  // as TOML, or "not given"
};

/// The first key, in the order of the file, by which a run of `one` by one engine and a run of `other` by another are
/// of different experiments: a key that shapes the experiment and that no engine owns, or the one engine of both. None
/// where there is no such key.
std::optional<Difference> first_difference(const Scene& one, std::string_view engine, const Scene& other,
                                           std::string_view other_engine);

}  // namespace shaken::scene
