// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace gloam::cli {

enum class Ink { good, bad };

// The text as standard output shows it best: in green or red on a terminal, plain elsewhere, and wherever
// NO_COLOR is set (https://no-color.org) or TERM is "dumb".
[[nodiscard]] std::string colored(std::string_view text, Ink ink);

}  // namespace gloam::cli
