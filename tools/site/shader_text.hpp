// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace gloam::site {

// A line without the blanks at its ends.
[[nodiscard]] std::string_view without_ends(std::string_view line);

// A GLSL text without its comments, indents and blank lines. Other lines stay lines of their own. Where it
// defines no macro, it is also without #undef lines.
[[nodiscard]] std::string condensed(std::string_view text);

}  // namespace gloam::site
