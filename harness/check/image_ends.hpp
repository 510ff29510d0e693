// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "check/question.hpp"

namespace gloam::check {

// The given scenarios and three more of the largest scenario's size: all pixels 0; all pixels 1; and a
// mixture of pixels that are 0, 1, zeros and ones by component, or unchanged. A pixel of three numbers 1
// becomes a unit vector along an axis. If an image has infinite pixels, the mixture has more of them.
[[nodiscard]] std::vector<ImageScenario> with_exact_ends(std::vector<ImageScenario> scenarios);

}  // namespace gloam::check
