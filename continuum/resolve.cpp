// SPDX-License-Identifier: MIT
#include "continuum/resolve.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "continuum/ftcs/ftcs.hpp"
#include "continuum/initial_state.hpp"
#include "continuum/reconstruct/reconstructions.hpp"
#include "scene/errors.hpp"

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

void resolve_ftcs(Scene& s) {
    scene::Continuum& c = s.continuum;
    Ftcs::refuse_closure(c);
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

}  // namespace

scene::Scene resolve(scene::Scene scene) {
    scene.without_part.clear();
    resolve_scheme(scene);
    if (scene.continuum.scheme.name == Ftcs::name) resolve_ftcs(scene);
    if (scene.kind == scene::Kind::layer) resolve_grid(scene);
    return scene;
}

}  // namespace shaken::continuum
