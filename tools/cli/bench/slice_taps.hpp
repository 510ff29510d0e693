// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "effect/study/plain_slices.hpp"

namespace gloam::cli {

// Parses SLICESxSTEPS, both 1 to 64: "9x3" is 9 slices of 3 steps to each side. Throws std::invalid_argument
// with the text otherwise.
[[nodiscard]] effect::SliceTaps slice_taps(const std::string& text);

}  // namespace gloam::cli
