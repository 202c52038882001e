// SPDX-License-Identifier: MIT
#include "continuum/resolve.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "continuum/closures/closures.hpp"
#include "continuum/closures/effective_dissipation.hpp"
#include "continuum/closures/equation_of_state.hpp"
#include "continuum/ftcs/ftcs.hpp"
#include "continuum/initial_state.hpp"
#include "continuum/parameters.hpp"
#include "continuum/reconstruct/reconstructions.hpp"
#include "continuum/verification.hpp"
#include "scene/errors.hpp"
#include "scene/text_visitor.hpp"

namespace shaken::continuum {

namespace {

using scene::Scene;
using scene::SceneError;

template <class Scheme>
bool uses(const std::string& key) {
    return std::find(Scheme::unused.begin(), Scheme::unused.end(), key) == Scheme::unused.end();
}

template <class... Types>
std::vector<std::string> schemes_that_use(Choices<Types...>, const std::string& key) {
    std::vector<std::string> names;
    const auto consider = [&](auto scheme) {
        if (uses<decltype(scheme)>(key)) names.emplace_back(scheme.name);
    };
    (consider(Types{}), ...);
    return names;
}

void resolve_scheme(Scene& s) {
    choose(Schemes{}, "continuum.scheme", s.continuum.scheme, [&](auto scheme) {
        for (const std::string_view word : decltype(scheme)::unused) {
            const std::string key(word), full = "continuum." + key;
            if (const auto written = s.written.find(full); written != s.written.end())
                throw SceneError(written->second,
                                 fmt::format("{} has no part in continuum.scheme = \"{}\": leave it out; schemes that "
                                             "use it: {}",
                                             full, scheme.name, fmt::join(schemes_that_use(Schemes{}, key), ", ")));
            s.without_part.insert(full);
        }
        return true;
    });
}

/// A key without a part in this run: refused where it is written, and not printed.
void leave_out(Scene& s, const std::string& key, const std::string& where) {
    if (s.written.contains(key))
        throw scene::refusal(s, key, fmt::format("{} has no part in {}: leave it out", key, where));
    s.without_part.insert(key);
}

void resolve_ftcs(Scene& s) {
    scene::Continuum& c = s.continuum;
    const bool of_grains = s.kind == scene::Kind::layer || s.kind == scene::Kind::uniform;
    Ftcs::refuse_closure(c, of_grains ? pressure_restitution(s) : s.tube.restitution);
    // The source's finite differences keep the source's wall.
    if (!s.written.contains("continuum.upper")) c.upper.name = "lid";
    const auto written = s.written.find("continuum.floor_density");
    if (written == s.written.end())
        c.floor_density = Ftcs::least_floor_density;
    else if (c.floor_density < Ftcs::least_floor_density)
        throw SceneError(written->second, fmt::format("continuum.floor_density = {} is below the least that "
                                                      "continuum.scheme = \"ftcs\" can run, {}",
                                                      c.floor_density, Ftcs::least_floor_density));
}

void resolve_grid(Scene& s) {
    const Grid grid = make_grid(s);
    const auto place = [&](const std::string& key) {
        const auto written = s.written.find(key);
        return written == s.written.end() ? s.continuum.dimension.place : written->second;
    };
    scene::Initial& start = s.initial;
    const auto refuse = [&](const std::string& key, const std::string& value, const std::string& lacks) {
        throw SceneError(place(key), fmt::format("{} = {} needs several columns {}; the grid has {} x {} "
                                                 "(continuum.dimension, spacing_horizontal)",
                                                 key, value, lacks, grid.nx, grid.ny));
    };
    if (start.noise > 0.0 && grid.columns() == 1) refuse("initial.noise", fmt::format("{}", start.noise), "in the box");
    if (start.wave > 0.0) {
        if (start.wave_x > 0 && grid.nx == 1) refuse("initial.wave_x", fmt::format("{}", start.wave_x), "along x");
        if (start.wave_y > 0 && grid.ny == 1) refuse("initial.wave_y", fmt::format("{}", start.wave_y), "along y");
    }
    scene::Continuum& c = s.continuum;
    c.dimension.name = fmt::format("{}", 1 + (grid.nx > 1 ? 1 : 0) + (grid.ny > 1 ? 1 : 0));
    c.spacing = grid.dz;
    if (grid.columns() == 1)
        s.without_part.insert("continuum.spacing_horizontal");
    else if (grid.nx == 1 || grid.ny == 1 || grid.dx == grid.dy)
        c.spacing_horizontal = grid.nx > 1 ? grid.dx : grid.dy;
}

/// The whole periods of sound that a wave is followed for.
double time_of_wave(const Scene& s) {
    const double speed = make_equation_of_state(s.continuum.pair_correlation, s.tube.restitution)
                             .sound_speed(s.tube.gas.volume_fraction, s.tube.gas.temperature);
    return periods_of_wave(s.tube.time, s.tube.length / speed).end;
}

void resolve_tube(Scene& s) {
    const auto& t = s.tube;
    s.continuum.spacing = t.length / std::round(t.length / s.continuum.spacing);
    if (s.continuum.scheme.name != Ftcs::name)
        leave_out(s, "continuum.floor_density",
                  fmt::format("continuum.scheme = \"{}\" of this kind", s.continuum.scheme.name));
    if (!closure_has_part(s.continuum, t.restitution))
        leave_out(s, "continuum.closure", "an inviscid gas that does not cool");
    if (s.kind == scene::Kind::riemann && t.lower.name != "piston")
        leave_out(s, "tube.speed", "a tube without a piston");
    if (s.kind == scene::Kind::column && t.wall_temperature)
        leave_out(s, "initial.volume_fraction", "a column on a heated bottom (initial.number_per_area says how much)");
    if (s.kind == scene::Kind::column && !t.wall_temperature)
        leave_out(s, "initial.number_per_area",
                  "a column without a heated bottom (initial.volume_fraction says how much)");
    if (s.kind == scene::Kind::wave) s.tube.time = time_of_wave(s);
}

}  // namespace

scene::Scene resolve_alone(scene::Scene scene) {
    scene = resolve(std::move(scene));
    if (scene.kind != scene::Kind::uniform) return scene;
    if (!scene.initial.file.empty())
        throw scene::refusal(scene, "initial.file",
                             "initial.file has no part in the continuum of a uniform gas: it starts from "
                             "initial.volume_fraction and temperature");
    for (const scene::KeyText& key : scene::keys_of(scene))
        if (!key.owner.empty() && key.owner != keys.name) scene.without_part.insert(key.full());
    for (const char* key : {"initial.seed", "initial.file", "sample.frames"}) scene.without_part.insert(key);
    return scene;
}

scene::Scene resolve(scene::Scene scene) {
    scene.without_part.clear();
    resolve_scheme(scene);
    if (scene.continuum.scheme.name == Ftcs::name) resolve_ftcs(scene);
    if (scene.kind == scene::Kind::layer)
        resolve_grid(scene);
    else if (scene.kind != scene::Kind::uniform)
        resolve_tube(scene);
    return scene;
}

}  // namespace shaken::continuum
