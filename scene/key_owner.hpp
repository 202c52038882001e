// SPDX-License-Identifier: MIT
// Who owns keys of a scene. The scene says what an experiment is; each engine adds the keys that it alone acts on, with
// their units, ranges, defaults and words, and refuses the values that it cannot run.
#pragma once

#include <string_view>
#include <vector>

namespace shaken::scene {

struct Scene;
class ParameterVisitor;

struct KeyOwner {
    std::string_view name;  // of the engine, as in `shaken md`, and of its section
    /// Shows the keys that it has, in a scene of that kind, in a section where others have keys too.
    void (*describe_shared)(Scene&, std::string_view section, ParameterVisitor&);
    /// Shows the sections of its own.
    void (*describe_own)(Scene&, ParameterVisitor&);
    /// Throws SceneError for values that contradict each other or ask for more than a machine holds; of a scene whose
    /// number_of_particles, depth and motion are known.
    void (*check)(const Scene&);
};

/// Whose keys a scene may have.
struct KeyOwners {
    std::vector<const KeyOwner*> list;
    bool all = true;  // false: there are others, whose keys are left alone
};

/// For an engine that reads what may have been written for several.
inline KeyOwners alone(const KeyOwner& owner) { return {{&owner}, false}; }

}  // namespace shaken::scene
