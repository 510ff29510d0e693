# SPDX-License-Identifier: MIT
# Warnings are errors where the code is ours; tests included.
add_library(gloam_warnings INTERFACE)
target_compile_options(gloam_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Werror
  -Wno-missing-field-initializers)  # designated initializers leave members out on purpose
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 imagines overlapping and overlong copies in std::string (its bugs 105651 and 105329).
  target_compile_options(gloam_warnings INTERFACE -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow)
endif()
