// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "module/compile.hpp"

namespace gloam::module {

// Reads a text file. If the environment variables GLOAM_SHADERS and GLOAM_SHADERS_OF name a folder and the
// folder of which it is a copy, a file of the latter is read from the copy where that has it; so `gloam
// mutate` gives any program other shaders. Throws std::runtime_error with the file's name if that fails:
// expected a regular file of at most base::largest_text bytes, none of them NUL. A byte order mark of UTF-8
// is left out.
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

// The file of #include "name" in a file of folder `from` (may be empty): from/name, otherwise that of the
// first root that contains it. The text can be untrusted: the file must lie below a root, also after symbolic
// links are followed. Throws std::runtime_error with the searched places, or with the roots if the only file
// of this name lies outside them.
[[nodiscard]] std::filesystem::path resolve_include(std::string_view name, const std::filesystem::path& from,
                                                    const std::vector<std::filesystem::path>& roots);

// Every file that a text reaches by #include directives, whether or not a condition disables them; the folder
// of the text is also a root. Each file is listed once with its text, in the order of first mention; a cache
// key must cover all of them. Files that cannot be included are skipped, because only the compiler knows
// whether a condition disables the directive. Throws std::runtime_error if the texts together have more than
// base::largest_text bytes.
struct IncludedFile {
    std::filesystem::path path;
    std::string text;
};
[[nodiscard]] std::vector<IncludedFile> include_closure(const source::Source& source,
                                                        const std::vector<std::filesystem::path>& roots);

}  // namespace gloam::module
