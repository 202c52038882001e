// SPDX-License-Identifier: MIT
#include "app/start_keys.hpp"

#include <fmt/format.h>

#include "continuum/initial_state.hpp"
#include "scene/errors.hpp"

namespace shaken::app {

run::Notes notes_of_start(const scene::Scene& scene) {
    const bool seeds = scene.md.seed != scene::Md{}.seed || scene.initial.seed != scene::Initial{}.seed;
    if (scene.initial.file.empty() || !seeds) return {};
    return {
        "The MD starts from initial.file, where md.seed and initial.seed have no part: runs from one state are "
        "one run, whatever their seeds."};
}

run::Notes notes_of_continuum_start(const scene::Scene& scene, bool beside_md) {
    if (scene.kind != scene::Kind::layer) return {};
    const scene::Initial &given = scene.initial, usual;
    run::Notes notes;
    if (given.wave == 0.0 && (given.wave_x != usual.wave_x || given.wave_y != usual.wave_y))
        notes.push_back(
            fmt::format("initial.wave_x = {} and initial.wave_y = {} have no part in a start without a wave: "
                        "initial.wave is 0.",
                        given.wave_x, given.wave_y));
    const bool random = given.noise > 0.0 && continuum::resolve_dimension(scene) > 1;
    if (!beside_md && !random && given.seed != usual.seed)
        notes.push_back(fmt::format(
            "initial.seed = {} has no part in a continuum that starts without noise: runs that differ in it are one "
            "run.",
            given.seed));
    return notes;
}

void refuse_phase_without_file(const scene::Scene& scene) {
    if (!scene.initial.file.empty() || scene.initial.phase == 0.0) return;
    const auto written = scene.written.find("initial.phase");
    throw scene::SceneError(written == scene.written.end() ? scene::Place{} : written->second,
                            fmt::format("initial.phase = {} needs initial.file: the start without one stands at ft = 0",
                                        scene.initial.phase));
}

}  // namespace shaken::app
