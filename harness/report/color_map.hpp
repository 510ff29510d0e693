// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace gloam::report {

// sRGB, 8 bits.
using Color = std::array<std::uint8_t, 3>;

// The colour of an error on a scale from 0 to 1: from nearly black over violet and red to pale yellow.
// Lightness rises evenly all the way (in Oklab), so that the order of values can be seen, in grey too. Below
// 0 as 0, above 1 as 1, NaN as 0.
[[nodiscard]] Color heat_color(double value);

}  // namespace gloam::report
