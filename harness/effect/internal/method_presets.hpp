// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "effect/presets.hpp"

namespace gloam::effect {

// The configurations that the methods were published and compared with, single frames at heart: the history
// is the paper's.
[[nodiscard]] std::vector<Preset> method_presets();

}  // namespace gloam::effect
