// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace gloam::cli {

// The folder that holds gloam/ and passes/: beside the installed program, else in the source tree it was
// built from. Throws std::runtime_error when neither is there.
[[nodiscard]] std::filesystem::path glsl_directory();

// The folder of the shaders that only `gloam stress` runs, found likewise.
[[nodiscard]] std::filesystem::path stress_shaders_directory();

// Where compiled shaders are kept: $GLOAM_CACHE_DIR, else gloam in $XDG_CACHE_HOME or ~/.cache; empty without
// a home.
[[nodiscard]] std::filesystem::path cache_directory();

// Where ray-traced truth is kept: in cache_directory(); empty without one.
[[nodiscard]] std::filesystem::path truth_cache_directory();

// Whether people are watching: standard error is a terminal.
[[nodiscard]] bool on_terminal();

}  // namespace gloam::cli
