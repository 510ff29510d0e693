// SPDX-License-Identifier: MIT
#include "numeric/ulp.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "numeric/constants.hpp"
#include "numeric/float_format.hpp"

namespace gloam::numeric {
namespace {

constexpr double largest = std::numeric_limits<float>::max();
constexpr double smallest_normal = std::numeric_limits<float>::min();

// 0 or infinity if the error is not a matter of distance; -1 if it is.
double settled_error(float got, double want) {
    if (std::isnan(got) || std::isnan(want)) return std::isnan(got) && std::isnan(want) ? 0.0 : infinity;
    if (std::abs(want) > largest) {
        const bool same_side = std::signbit(got) == std::signbit(want);
        const bool exact = same_side && (std::isinf(got) || (!std::isinf(want) && std::abs(got) >= largest));
        return exact ? 0.0 : infinity;
    }
    if (std::isinf(got)) return infinity;
    if (std::abs(want) < smallest_normal && got == 0.0F) return 0.0;
    return -1.0;
}

}  // namespace

double ulp_size(double x) {
    return std::isfinite(x) ? float32.ulp(x) : std::numeric_limits<double>::quiet_NaN();
}

double ulp_error(float got, double want) {
    const double settled = settled_error(got, want);
    return settled >= 0.0 ? settled : std::abs(static_cast<double>(got) - want) / ulp_size(want);
}

double absolute_error(float got, double want) {
    const double settled = settled_error(got, want);
    return settled >= 0.0 ? settled : std::abs(static_cast<double>(got) - want);
}

float step(float x, int steps) {
    if (std::isnan(x)) return x;
    // Maps floats to integers that count representable values from zero.
    const auto bits = std::bit_cast<std::uint32_t>(x);
    const auto magnitude = static_cast<std::int64_t>(bits & 0x7fffffffU);
    const std::int64_t ordinal = (bits >> 31) != 0 ? -magnitude : magnitude;
    constexpr std::int64_t last = 0x7f800000;  // infinity
    const std::int64_t moved = std::clamp(ordinal + steps, -last, last);
    const auto absolute = static_cast<std::uint32_t>(std::abs(moved));
    return std::bit_cast<float>(moved < 0 ? absolute | 0x80000000U : absolute);
}

}  // namespace gloam::numeric
