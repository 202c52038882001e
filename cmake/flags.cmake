# Compiler flags of the whole project, on one interface target; nothing global.
add_library(shaken_flags INTERFACE)
target_compile_features(shaken_flags INTERFACE cxx_std_20)
target_include_directories(shaken_flags INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
target_compile_options(shaken_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
# A loop that clang leaves scalar is no fault of the source; under a sanitizer there are dozens.
target_compile_options(shaken_flags INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-pass-failed>)
# A fused multiply-add rounds once where two operations round twice. Left to the compiler it would differ between
# inlined copies of one formula, and a restart or a mirrored flow would no longer give the same bits.
target_compile_options(shaken_flags INTERFACE -ffp-contract=off)

option(SHAKEN_TUNE_NATIVE "Tune for the machine it is built on (-march=native)" OFF)
if(SHAKEN_TUNE_NATIVE)
  target_compile_options(shaken_flags INTERFACE -march=native)
endif()

set(SHAKEN_SANITIZE "" CACHE STRING "Sanitizers, as for -fsanitize= (address,undefined or thread)")
if(SHAKEN_SANITIZE)
  target_compile_options(shaken_flags INTERFACE -fsanitize=${SHAKEN_SANITIZE} -fno-omit-frame-pointer
                                                -fno-sanitize-recover=all)
  target_link_options(shaken_flags INTERFACE -fsanitize=${SHAKEN_SANITIZE})
endif()

add_library(shaken::flags ALIAS shaken_flags)
