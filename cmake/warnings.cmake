# SPDX-License-Identifier: MIT
# The warnings for gloam's own code, tests included. They stop the build where CMAKE_COMPILE_WARNING_AS_ERROR is set
# (.ci/run, the presets debug and sanitize). They never stop the build of a project that only uses gloam.
add_library(gloam_warnings INTERFACE)
target_compile_options(gloam_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion
  -Wno-missing-field-initializers)  # designated initializers leave members out on purpose
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 and 14 imagine overlapping and overlong copies in std::string (GCC's bugs 105651 and 105329).
  target_compile_options(gloam_warnings INTERFACE -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow)
  if(GLOAM_SANITIZE)
    # With the address sanitizer GCC 12 takes members of std::function in std::regex for uninitialized (bug 105562).
    target_compile_options(gloam_warnings INTERFACE -Wno-maybe-uninitialized)
  endif()
endif()
