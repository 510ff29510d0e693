// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "catalogue/entry.hpp"

namespace gloam::catalogue {

// Every equation, room by room in the order of glsl/gloam.
[[nodiscard]] Entries all_entries();

// The entries whose ID or function matches one of the patterns (shell globs: * and ?, in any case); without
// patterns all. Throws std::invalid_argument with a pattern that matches nothing.
[[nodiscard]] Entries select(const Entries& entries, const std::vector<std::string>& patterns);

// Whether the text matches the glob, in any case.
[[nodiscard]] bool matches_glob(std::string_view text, std::string_view glob);

}  // namespace gloam::catalogue
