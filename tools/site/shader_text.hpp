// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace gloam::site {

// A GLSL text without its comments, indents and blank lines. Other lines stay lines of their own.
[[nodiscard]] std::string without_comments(std::string_view text);

}  // namespace gloam::site
