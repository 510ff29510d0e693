// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace gloam::cli {

// A progress bar with the time left, on a line of standard error. Call the result with the completed part, in
// [0, 1], at any rate; at 1 the line is erased, and below 0, so that other lines can be written. It prints
// nothing if standard error is not a terminal, or if the bar is not `watched`.
[[nodiscard]] std::function<void(double)> progress_bar(std::string what, bool watched = true);

enum class Ink { good, bad };

// The text in green or red if standard output is a terminal; plain otherwise, and if NO_COLOR is set
// (https://no-color.org) or TERM is "dumb".
[[nodiscard]] std::string colored(std::string_view text, Ink ink);

}  // namespace gloam::cli
