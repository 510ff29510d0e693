// SPDX-License-Identifier: MIT
#include "base/half.hpp"

#include "support/test.hpp"

namespace gloam::base::half_test {

constexpr std::uint16_t infinite = 0x7c00;

// The value by definition.
double value(std::uint16_t half) {
    const int exponent = half >> 10 & 0x1f;
    const int fraction = half & 0x3ff;
    const double magnitude =
        exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
    return (half & 0x8000u) != 0 ? -magnitude : magnitude;
}

TEST(Half, EveryFiniteHalfIsExactBothWays) {
    for (std::uint32_t bits = 0; bits < 0x10000; ++bits) {
        const auto half = static_cast<std::uint16_t>(bits);
        if ((half & 0x7fffu) >= infinite) continue;
        ASSERT_EQ(static_cast<double>(from_half(half)), value(half)) << bits;
        ASSERT_EQ(std::signbit(from_half(half)), (half & 0x8000u) != 0) << bits;
        ASSERT_EQ(to_half(from_half(half)), half);
    }
}

// Between neighbours, with one float32 step either side of the middle; the even one wins the tie. Infinity
// counts as the neighbour of the largest, at 65536.
TEST(Half, RoundsToNearestEven) {
    for (std::uint16_t lower = 0; lower < infinite; ++lower) {
        const auto upper = static_cast<std::uint16_t>(lower + 1);
        const auto middle = static_cast<float>((value(lower) + value(upper)) / 2);
        ASSERT_EQ(static_cast<double>(middle), (value(lower) + value(upper)) / 2);
        for (const auto& [at, half] : {std::pair{middle, (lower & 1u) == 0 ? lower : upper},
                                       {std::nextafter(middle, 0.0f), lower},
                                       {std::nextafter(middle, 1e30f), upper}}) {
            ASSERT_EQ(to_half(at), half) << at;
            ASSERT_EQ(to_half(-at), half | 0x8000) << at;
        }
    }
}

TEST(Half, BeyondItsRangeAndNaN) {
    for (const float large : {std::numeric_limits<float>::max(), infinity}) {
        EXPECT_EQ(to_half(large), infinite);
        EXPECT_EQ(to_half(-large), 0xfc00);
    }
    EXPECT_EQ(from_half(0xfc00), -infinity);
    EXPECT_EQ(to_half(-std::numeric_limits<float>::denorm_min()), 0x8000);
    for (const std::uint32_t bits : {0x7f800001u, 0x7fc00000u, 0x7fffffffu, 0xffc00001u, 0xff800001u})
        EXPECT_GT(to_half(std::bit_cast<float>(bits)) & 0x7fff, infinite) << bits;
    for (std::uint32_t fraction = 1; fraction < 0x400; ++fraction)
        EXPECT_TRUE(std::isnan(from_half(static_cast<std::uint16_t>(infinite | fraction))));
}

}  // namespace gloam::base::half_test
