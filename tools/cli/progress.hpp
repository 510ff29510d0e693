// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

namespace gloam::cli {

// A bar on a line of standard error, for work of which the part done is known, in [0, 1]: call it as often as
// you like. Nothing where nobody watches; the line is wiped at 1.
[[nodiscard]] std::function<void(double)> progress_bar(std::string what);

}  // namespace gloam::cli
