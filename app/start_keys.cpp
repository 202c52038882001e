// SPDX-License-Identifier: MIT
#include "app/start_keys.hpp"

#include <fmt/format.h>

#include "scene/errors.hpp"

namespace shaken::app {

Notes notes_of_start(const scene::Scene& scene) {
    const bool seeds = scene.md.seed != scene::Md{}.seed || scene.initial.seed != scene::Initial{}.seed;
    if (scene.initial.file.empty() || !seeds) return {};
    return {
        "The MD starts from initial.file, where md.seed and initial.seed have no part: runs from one state are "
        "one run, whatever their seeds."};
}

void refuse_phase_without_file(const scene::Scene& scene) {
    if (!scene.initial.file.empty() || scene.initial.phase == 0.0) return;
    const auto written = scene.written.find("initial.phase");
    throw scene::SceneError(written == scene.written.end() ? scene::Place{} : written->second,
                            fmt::format("initial.phase = {} needs initial.file: the start without one stands at ft = 0",
                                        scene.initial.phase));
}

}  // namespace shaken::app
