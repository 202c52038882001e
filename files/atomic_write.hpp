// SPDX-License-Identifier: MIT
// Whole files, written so that a crash or a full disk leaves either the old content or the new, never a part.
#pragma once

#include <filesystem>
#include <string_view>

namespace shaken::files {

/// Temporary file beside `path`, fsync, rename over it, fsync of the folder. Throws CannotCreate or WriteFailed.
void write_atomically(const std::filesystem::path& path, std::string_view content);

}  // namespace shaken::files
