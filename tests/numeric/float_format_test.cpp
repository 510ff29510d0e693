// SPDX-License-Identifier: MIT
#include "numeric/numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "halves.hpp"
#include "numeric/random.hpp"

namespace gloam::numeric {
namespace float_format_test {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(FloatFormat, KnowsItsLimits) {
    EXPECT_EQ(float32.largest(), std::numeric_limits<float>::max());
    EXPECT_EQ(float32.smallest_normal(), std::numeric_limits<float>::min());
    EXPECT_EQ(float32.smallest_subnormal(), std::numeric_limits<float>::denorm_min());
    EXPECT_EQ(float16.largest(), 65504.0);
    EXPECT_EQ(float16.smallest_normal(), 0x1p-14);
    EXPECT_EQ(float16.smallest_subnormal(), 0x1p-24);
}

TEST(FloatFormat, EveryHalfIsItsOwnNeighbour) {
    for (const double value : halves::finite()) {
        ASSERT_EQ(float16.round_down(value), value);
        ASSERT_EQ(float16.round_up(value), value);
        ASSERT_EQ(float16.ulp(value), halves::gap(value)) << value;
    }
}

TEST(FloatFormat, NumbersBetweenTwoHalvesGoToBoth) {
    const auto& all = halves::finite();
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        for (const double part : {0x1p-30, 0.5, 1.0 - 0x1p-30}) {
            const double between = all[i] + part * (all[i + 1] - all[i]);
            ASSERT_EQ(float16.round_down(between), all[i]) << between;
            ASSERT_EQ(float16.round_up(between), all[i + 1]) << between;
        }
    }
}

TEST(FloatFormat, BeyondTheLargestValueLieItAndInfinity) {
    for (const FloatFormat& format : {float32, float16}) {
        const double beyond = std::nextafter(format.largest(), infinity);
        EXPECT_EQ(format.round_down(beyond), format.largest());
        EXPECT_EQ(format.round_up(beyond), infinity);
        EXPECT_EQ(format.round_down(-beyond), -infinity);
        EXPECT_EQ(format.round_up(-beyond), -format.largest());
        EXPECT_EQ(format.round_down(infinity), infinity);
        EXPECT_EQ(format.round_up(-infinity), -infinity);
    }
}

TEST(FloatFormat, RoundsToTheNeighboursOfFloat32) {
    Random random(1);
    for (int i = 0; i < 100'000; ++i) {
        const double x = std::ldexp(random.uniform(-2, 2), static_cast<int>(random.below(290)) - 150);
        const double down = float32.round_down(x);
        const double up = float32.round_up(x);
        ASSERT_TRUE(down <= x && x <= up) << x;
        ASSERT_EQ(static_cast<float>(down), down);
        const double next = std::nextafter(static_cast<float>(down), std::numeric_limits<float>::infinity());
        ASSERT_TRUE(up == down || up == next) << x;
    }
}

TEST(FloatFormat, UlpIsTheGapBelowAPowerOfTwo) {
    EXPECT_EQ(float32.ulp(1.0), 0x1p-24);
    EXPECT_EQ(float32.ulp(std::nextafter(1.0, 2.0)), 0x1p-23);
    EXPECT_EQ(float32.ulp(0.0), 0x1p-149);
    EXPECT_EQ(float32.ulp(0x1p-126), 0x1p-149);
    EXPECT_EQ(float32.ulp(1e300), 0x1p104);
}

}  // namespace float_format_test
}  // namespace gloam::numeric
