// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "shader/compile.hpp"

namespace gloam::shader {

// Reads a text file; throws std::runtime_error naming the file when it cannot.
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

// The file that #include "name" means in a file of folder `from` (may be empty): from/name, else the first
// root that has it. Throws std::runtime_error that lists where it looked.
[[nodiscard]] std::filesystem::path resolve_include(std::string_view name, const std::filesystem::path& from,
                                                    const std::vector<std::filesystem::path>& roots);

// Every file that a text of folder `from` reaches through #include directives (whether or not a condition
// hides them), each once, in the order of first mention, with its text: what a cache key must cover. Files
// that are missing are left out (only the compiler knows whether a condition hides them).
struct IncludedFile {
    std::filesystem::path path;
    std::string text;
};
[[nodiscard]] std::vector<IncludedFile> include_closure(std::string_view text,
                                                        const std::vector<std::filesystem::path>& roots,
                                                        const std::filesystem::path& from = {});

}  // namespace gloam::shader
