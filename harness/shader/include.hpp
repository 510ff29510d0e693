// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "shader/compile.hpp"

namespace gloam::shader {

// Reads a text file. Throws std::runtime_error with the file's name if that fails.
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

// The file of #include "name" in a file of folder `from` (may be empty): from/name, otherwise that of the
// first root that contains it. Throws std::runtime_error with the searched places.
[[nodiscard]] std::filesystem::path resolve_include(std::string_view name, const std::filesystem::path& from,
                                                    const std::vector<std::filesystem::path>& roots);

// Every file that a text of folder `from` reaches by #include directives, whether or not a condition disables
// them. Each file is listed once with its text, in the order of first mention; a cache key must cover all of
// them. Missing files are skipped, because only the compiler knows whether a condition disables the
// directive.
struct IncludedFile {
    std::filesystem::path path;
    std::string text;
};
[[nodiscard]] std::vector<IncludedFile> include_closure(std::string_view text,
                                                        const std::vector<std::filesystem::path>& roots,
                                                        const std::filesystem::path& from = {});

}  // namespace gloam::shader
