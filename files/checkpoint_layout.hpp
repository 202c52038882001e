// SPDX-License-Identifier: MIT
// The first bytes of a checkpoint, for its reader and its writers.
#pragma once

#include <xxhash.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace shaken::files::checkpoint_layout {

inline constexpr std::string_view magic = "SHKNCKP1";
inline constexpr std::size_t header_size = 8 + 8 + sizeof(XXH128_canonical_t);

inline std::string header(std::uint64_t body_size, const XXH128_canonical_t& checksum) {
    std::string bytes(magic);
    bytes.append(reinterpret_cast<const char*>(&body_size), sizeof body_size);
    bytes.append(reinterpret_cast<const char*>(&checksum), sizeof checksum);
    return bytes;
}

}  // namespace shaken::files::checkpoint_layout
