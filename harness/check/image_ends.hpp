// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "check/question.hpp"

namespace gloam::check {

// The scenarios, and three more in the size of the largest: all pixels 0; all 1; and pixels that are 0, 1, of
// zeros and ones, or as they were. Three numbers that are 1 are a unit vector along an axis. Where an image
// has infinite pixels, the last has more of them.
[[nodiscard]] std::vector<ImageScenario> with_exact_ends(std::vector<ImageScenario> scenarios);

}  // namespace gloam::check
