// SPDX-License-Identifier: MIT
#include "compare/scenes.hpp"

#include <fmt/format.h>

#include "continuum/parameters.hpp"
#include "files/errors.hpp"
#include "md/parameters.hpp"
#include "scene/differences.hpp"
#include "scene/read_scene.hpp"

namespace shaken::compare {

scene::KeyOwners both_engines() { return {{&md::keys, &continuum::keys}}; }

scene::Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
    return scene::read_scene(path, both_engines(), overrides);
}

scene::Scene parse_scene(const std::string& text, const std::string& source,
                         const std::vector<std::string>& overrides) {
    return scene::parse_scene(text, source, both_engines(), overrides);
}

void refuse_other_experiment(const RecordedRun& one, const RecordedRun& other) {
    const auto difference = scene::first_difference(one.scene, one.engine, other.scene, other.engine);
    if (!difference) return;
    throw files::Damaged(
        fmt::format("{} and {}: runs of different scenes, {} = {} and {}; they may differ in seeds, start, length{}",
                    one.path.string(), other.path.string(), difference->key, difference->one, difference->other,
                    one.engine == other.engine ? " and method" : ", method and what one engine alone acts on"));
}

}  // namespace shaken::compare
