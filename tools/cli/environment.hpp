// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gloam::cli {

// A folder of the program's files, beside the installed program, otherwise in the source tree of the build:
// "glsl" (gloam/ and passes/), "stress" (shaders of `gloam stress` alone), "site" (what runs in a browser),
// "docs" (the pages), "experiments" (of `gloam bench`). Throws std::runtime_error if neither exists.
[[nodiscard]] std::filesystem::path data_directory(std::string_view name);
[[nodiscard]] std::filesystem::path glsl_directory();

// The path of a file, or of one of the library by its name there ("gloam/filter/weights.glsl").
[[nodiscard]] std::string path_of_shader(const std::string& file);

// The include roots of a user's file: its folder, further ones, and glsl_directory().
[[nodiscard]] std::vector<std::filesystem::path> include_roots_of(const std::filesystem::path& file,
                                                                  const std::vector<std::string>& further);

// Folder for compiled shaders: $GLOAM_CACHE_DIR, else gloam in $XDG_CACHE_HOME or ~/.cache, or none: empty.
[[nodiscard]] std::filesystem::path cache_directory();

// Folder for ray-traced truth, in cache_directory(); empty without that.
[[nodiscard]] std::filesystem::path truth_cache_directory();

// "gloam 0.4.0, glslang 11.13.0 (generator 10), SPIRV-Tools v2022.4, SPIRV-Cross ...": the versions on which
// a result depends, besides the device and its driver.
[[nodiscard]] std::string versions();

}  // namespace gloam::cli
