// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

namespace gloam::numeric {

// Classes of float32 values that arithmetic treats differently. `huge`: the square overflows (|x| >= 2^64).
enum class FloatClass { ordinary, zero, subnormal, huge, infinite, nan };

[[nodiscard]] inline FloatClass classify(float x) {
    if (std::isnan(x)) return FloatClass::nan;
    if (std::isinf(x)) return FloatClass::infinite;
    if (x == 0.0F) return FloatClass::zero;
    const float magnitude = std::abs(x);
    if (magnitude < std::numeric_limits<float>::min()) return FloatClass::subnormal;
    return magnitude >= 0x1p64F ? FloatClass::huge : FloatClass::ordinary;
}

}  // namespace gloam::numeric
