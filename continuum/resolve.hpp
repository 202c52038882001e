// SPDX-License-Identifier: MIT
// What of a scene's [continuum] runs: the one place where settings that hang on other settings get their values, and
// where settings that the run cannot honour are refused. Whoever prints a scene beside a run prints this one.
#pragma once

#include "scene/scene.hpp"

namespace shaken::continuum {

/// The scene with, for a layer, dimension as a number and the spacings of its grid; for a tube the spacing of its cells
/// and, for a wave, the whole periods that it is followed for; for the scheme ftcs its own defaults of upper and
/// floor_density; and the list of keys that have no part in what runs. Resolving twice changes nothing.
/// Throws scene::SceneError, at the place of the key, for a key written out that the scheme has no use for, a closure
/// or a floor that it cannot run, and noise or waves across columns that the grid does not have.
scene::Scene resolve(scene::Scene scene);

/// The same of a scene that the continuum runs by itself, for a record of that: of a uniform gas, without what the MD
/// alone acts on. Throws scene::SceneError for a start from a file, too, which a uniform gas does not have here.
scene::Scene resolve_alone(scene::Scene scene);

}  // namespace shaken::continuum
