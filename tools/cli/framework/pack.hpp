// SPDX-License-Identifier: MIT
#pragma once

#include "cli/commands.hpp"
#include "module/compile.hpp"

namespace gloam::cli {

// The options of `gloam pack` for files and functions.
struct PackOptions {
    std::vector<std::string> files;
    std::vector<std::string> functions;
    std::vector<std::string> includes;  // further include roots
    std::vector<std::string> defines;   // macros before the files
    std::string version = "450";
    std::string target;  // empty: GLSL
    std::filesystem::path out;
};
[[nodiscard]] std::vector<Option> pack_options(PackOptions& options);

// Writes the files, or the equations, as one text.
void pack_files(const PackOptions& options, EquationsNamed* equations);

// A Markdown table: for each file its lines of code as packed, without blank ones and comments, and behind
// them those of all together, each function once. Throws like module::pack().
[[nodiscard]] std::string line_table(const std::vector<std::string>& files);

// The packed text with gloam's version, and what takes this language, at its head: behind its #version.
[[nodiscard]] std::string with_version(std::string text, std::optional<source::Language> language);

}  // namespace gloam::cli
