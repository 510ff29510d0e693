// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace gloam::cli {

enum class Ink { good, bad };

// The text in green or red if standard output is a terminal; plain otherwise, and if NO_COLOR is set
// (https://no-color.org) or TERM is "dumb".
[[nodiscard]] std::string colored(std::string_view text, Ink ink);

}  // namespace gloam::cli
