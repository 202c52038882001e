// SPDX-License-Identifier: MIT
// Whole files, written so that a crash or a full disk leaves either the old content or the new, never a part.
#pragma once

#include <filesystem>
#include <string_view>

namespace shaken::files {

/// Renames a synced file over `path` and syncs the folder. Throws WriteFailed, and then removes the temporary one.
void take_its_place(const std::filesystem::path& temporary, const std::filesystem::path& path);

/// Temporary file beside `path`, fsync, rename over it, fsync of the folder. Throws CannotCreate or WriteFailed.
void write_atomically(const std::filesystem::path& path, std::string_view content);

}  // namespace shaken::files
