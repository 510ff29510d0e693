// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>

namespace gloam::numeric {

// Float32 values at which arithmetic behaves differently: signed zeros, the ends of the subnormal and normal
// ranges, ones, the limit of exact integers, squares that overflow or underflow, infinities, NaN.
inline constexpr std::array special_floats{
    0.0F,
    -0.0F,
    std::numeric_limits<float>::denorm_min(),
    -std::numeric_limits<float>::denorm_min(),
    0x1.fffffcp-127F,  // largest subnormal
    std::numeric_limits<float>::min(),
    -std::numeric_limits<float>::min(),
    0x1p-64F,
    0x1.fffffep-1F,
    1.0F,
    0x1.000002p0F,
    -1.0F,
    0x1p24F,
    0x1p64F,
    std::numeric_limits<float>::max(),
    -std::numeric_limits<float>::max(),
    std::numeric_limits<float>::infinity(),
    -std::numeric_limits<float>::infinity(),
    std::numeric_limits<float>::quiet_NaN(),
};

}  // namespace gloam::numeric
