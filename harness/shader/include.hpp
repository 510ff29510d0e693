// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gloam::shader {

// Reads a text file; throws std::runtime_error naming the file when it cannot.
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

// The file that #include "name" means in a file of folder `from` (may be empty): from/name, else the first root that has it.
// Throws std::runtime_error that lists where it looked.
[[nodiscard]] std::filesystem::path resolve_include(std::string_view name, const std::filesystem::path& from,
                                                    const std::vector<std::filesystem::path>& roots);

// Every file that the text reaches through #include directives (whether or not a condition hides them), each once,
// in the order of first mention, with its text: what a cache key must cover.
struct IncludedFile {
    std::filesystem::path path;
    std::string text;
};
[[nodiscard]] std::vector<IncludedFile> include_closure(std::string_view text, const std::vector<std::filesystem::path>& roots);

// One self-contained text of the given files and all they include: dependencies first, each file once, include
// directives and include guards removed, comments kept, duplicate SPDX lines merged. No #version line.
[[nodiscard]] std::string flatten(const std::vector<std::filesystem::path>& files, const std::vector<std::filesystem::path>& roots);

}  // namespace gloam::shader
