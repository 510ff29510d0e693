# SPDX-License-Identifier: MIT
# Warnings are errors where the code is ours; tests included.
add_library(gloam_warnings INTERFACE)
target_compile_options(gloam_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Werror
  -Wno-missing-field-initializers)  # designated initializers leave members out on purpose
