// SPDX-License-Identifier: MIT
#include "files/provenance.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

#include "shaken_version.hpp"

namespace shaken::files {

void write_provenance(Hdf5File& file, const Provenance& provenance) {
    file.write_text("/provenance/program", fmt::format("shaken {}", version::number));
    file.write_text("/provenance/git_hash", version::git_hash);
    file.write_text("/provenance/compiler", version::compiler);
    file.write_text("/provenance/compiler_flags", version::compiler_flags);
    file.write_text("/provenance/scene", provenance.scene_text);
    file.write_text("/provenance/parent", provenance.parent);
    file.write<std::uint64_t>("/provenance/seed", std::span(&provenance.seed, 1), Shape{});
    file.write_text("/parameters/units",
                    "length sigma (sphere diameter), mass m (sphere), time sqrt(sigma/g): sigma = m = g = 1");
    file.attribute("/provenance", "written_at", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))));
}

}  // namespace shaken::files
