// SPDX-License-Identifier: MIT
// compare.h5: both engines on the same bins at every phase, with layer, shock, Mach number and mean free path, and the
// standard errors of MD. Layout in docs/formats.md.
#pragma once

#include <filesystem>

#include "compare/analysis.hpp"
#include "compare/mach.hpp"
#include "files/provenance.hpp"

namespace shaken::compare {

/// Replaces an existing file. Both must have the same phases and bins: throws std::invalid_argument otherwise;
/// files::CannotCreate or WriteFailed where it cannot be written.
void write_compare_file(const std::filesystem::path& path, const Measured& md, const Measured& continuum,
                        const Medium& medium, const files::Provenance& provenance);

}  // namespace shaken::compare
