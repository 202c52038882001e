// SPDX-License-Identifier: MIT
// What every output file says of its origin: program, commit, compiler, flags, scene, seed, units, parent.
#pragma once

#include <cstdint>
#include <string>

#include "files/hdf5.hpp"

namespace shaken::files {

struct Provenance {
    std::string scene_text;  // the resolved scene, TOML
    std::uint64_t seed = 0;
    std::string parent;  // checkpoint this run went on from, or empty
};

/// Writes group /provenance and the units under /parameters/units. Wall-clock time goes to an attribute only, so
/// that data compare exactly.
void write_provenance(Hdf5File& file, const Provenance& provenance);

}  // namespace shaken::files
