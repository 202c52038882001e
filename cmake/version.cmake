# The version header: git hash and state at build time, compiler and flags as configured.
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type_upper)
set(SHAKEN_COMPILER "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type_upper}}" SHAKEN_COMPILER_FLAGS)
if(SHAKEN_TUNE_NATIVE)
  string(APPEND SHAKEN_COMPILER_FLAGS " -march=native")
endif()
if(SHAKEN_SANITIZE)
  string(APPEND SHAKEN_COMPILER_FLAGS " -fsanitize=${SHAKEN_SANITIZE}")
endif()
string(APPEND SHAKEN_COMPILER_FLAGS " -ffp-contract=off")
add_custom_target(shaken_version
  COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D OUTPUT=${PROJECT_BINARY_DIR}/generated/shaken_version.hpp
          -D VERSION=${PROJECT_VERSION} "-DCOMPILER=${SHAKEN_COMPILER}" "-DFLAGS=${SHAKEN_COMPILER_FLAGS}"
          -P ${PROJECT_SOURCE_DIR}/cmake/write_version.cmake
  BYPRODUCTS ${PROJECT_BINARY_DIR}/generated/shaken_version.hpp
  COMMENT "" VERBATIM)
