// SPDX-License-Identifier: MIT
// `shaken md` and `shaken continuum`: one engine of a scene into a run folder, from the start or from a checkpoint.
#pragma once

#include "app/options.hpp"

namespace shaken::app {

/// Both return an exit code (done or stopped) and throw what goes wrong.
int run_md(const EngineOptions& options);
int run_continuum(const EngineOptions& options);

}  // namespace shaken::app
