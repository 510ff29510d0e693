# SPDX-License-Identifier: MIT
# Warnings are errors where the code is ours; tests included.
add_library(gloam_warnings INTERFACE)
target_compile_options(gloam_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Werror
  -Wno-missing-field-initializers)  # designated initializers leave members out on purpose
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 sees overlapping copies in std::string's operator+ (its bug 105651).
  target_compile_options(gloam_warnings INTERFACE -Wno-restrict)
endif()
