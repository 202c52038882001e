# Run at every build: writes the version header when the commit has changed, and only then.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12 --match=no-tag
                OUTPUT_VARIABLE hash OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed OR NOT hash)
  set(hash "unknown")
endif()
file(WRITE ${OUTPUT}.new "// Written by cmake/write_version.cmake.
#pragma once
namespace version {
inline constexpr const char* number = \"${VERSION}\";
inline constexpr const char* git_hash = \"${hash}\";
inline constexpr const char* compiler = \"${COMPILER}\";
inline constexpr const char* compiler_flags = \"${FLAGS}\";
}  // namespace version
")
execute_process(COMMAND ${CMAKE_COMMAND} -E copy_if_different ${OUTPUT}.new ${OUTPUT})
file(REMOVE ${OUTPUT}.new)
