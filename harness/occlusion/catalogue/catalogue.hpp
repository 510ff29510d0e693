// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "catalogue/entry.hpp"

namespace gloam::catalogue {

// Every equation, room by room in the order of glsl/gloam, as the comments of the shader library in the
// folder `glsl` describe it. Throws std::runtime_error that names the first equation that they do not
// describe.
[[nodiscard]] Entries all_entries(const std::filesystem::path& glsl);

// The entries whose ID or function matches one of the patterns (shell globs: * and ?, in any case); without
// patterns all. Throws std::invalid_argument with a pattern that matches nothing.
[[nodiscard]] Entries select(const Entries& entries, const std::vector<std::string>& patterns);

// Whether the text matches the glob, in any case.
[[nodiscard]] bool matches_glob(std::string_view text, std::string_view glob);

}  // namespace gloam::catalogue
