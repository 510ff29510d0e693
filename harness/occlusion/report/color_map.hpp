// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace gloam::report {

// sRGB, 8 bits.
using Color = std::array<std::uint8_t, 3>;

// The colour of an error on a scale from 0 to 1: from nearly black over violet and red to pale yellow.
// Lightness rises evenly (in Oklab), so that the order of values is visible in grey as well. Values are
// clamped to [0, 1]; NaN counts as 0.
[[nodiscard]] Color heat_color(double value);

}  // namespace gloam::report
