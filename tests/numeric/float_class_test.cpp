// SPDX-License-Identifier: MIT
#include "numeric/numbers.hpp"

#include <gtest/gtest.h>

#include "numeric/random.hpp"

namespace gloam::numeric {
namespace float_class_test {

TEST(FloatClass, EveryClassHasItsValues) {
    EXPECT_EQ(classify(0.0F), FloatClass::zero);
    EXPECT_EQ(classify(-0.0F), FloatClass::zero);
    EXPECT_EQ(classify(0x1p-149F), FloatClass::subnormal);
    EXPECT_EQ(classify(-0x1.fffffcp-127F), FloatClass::subnormal);
    EXPECT_EQ(classify(0x1p-126F), FloatClass::ordinary);
    EXPECT_EQ(classify(0x1.fffffep63F), FloatClass::ordinary);
    EXPECT_EQ(classify(-0x1p64F), FloatClass::huge);
    EXPECT_EQ(classify(std::numeric_limits<float>::infinity()), FloatClass::infinite);
    EXPECT_EQ(classify(std::numeric_limits<float>::quiet_NaN()), FloatClass::nan);
}

TEST(Text, ShowsDecimalAndBits) {
    EXPECT_EQ(to_text(0.1F), "0.1 (0x3dcccccd)");
    EXPECT_EQ(to_text(-0.0F), "-0 (0x80000000)");
    EXPECT_EQ(to_text(0.1), "0.1 (0x1.999999999999ap-4)");
    EXPECT_EQ(to_text(0.0), "0 (0x0p+0)");
    EXPECT_EQ(to_text(-0.0), "-0 (-0x0p+0)");
    EXPECT_EQ(to_short_text(0.678), "0.68");
    EXPECT_EQ(to_short_text(1.5e41), "1.5e+41");  // once 44 digits
    EXPECT_EQ(to_short_text(-1.0 / 0.0), "-inf");
}

TEST(Random, IsTheSameOnEveryMachine) {
    Random random(1);
    EXPECT_EQ(random.bits(), 2469588189546311528U) << "the first number of mt19937_64 from seed 1";
    Random unit(2);
    for (int i = 0; i < 10'000; ++i) {
        const double x = unit.unit();
        ASSERT_GE(x, 0.0);
        ASSERT_LT(x, 1.0);
    }
}

}  // namespace float_class_test
}  // namespace gloam::numeric
