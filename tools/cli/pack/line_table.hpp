// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gloam::cli {

// A Markdown table: for each file its lines of code as packed, without blank ones and comments. Without
// files: those of glsl/gloam/methods, and the passes of each method's effect. Throws like shader::pack().
[[nodiscard]] std::string line_table(const std::filesystem::path& glsl,
                                     const std::vector<std::string>& files);

}  // namespace gloam::cli
