// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/lab.hpp"

namespace gloam::shading_test {

constexpr float infinity = std::numeric_limits<float>::infinity();

class Remap : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
    check::Kernel<float(float, float, float, float)> remap{lab, "gloam/shading/remap.glsl", "gloam_remap"};
};

TEST_F(Remap, KnownValues) {
    EXPECT_EQ(remap(0.5F, 0.5F, 1.0F, 2.0F), 1.0F);
    EXPECT_NEAR(remap(0.25F, 0.5F, 1.0F, 2.0F), 0.5625, 1e-6);
    EXPECT_NEAR(remap(0.25F, 0.0F, 1.0F, 0.5F), 0.5, 1e-6);
    EXPECT_NEAR(remap(0.25F, 0.0F, 2.0F, 3.0F), 0.125, 1e-6);
    EXPECT_EQ(remap(0.25F, 0.25F, 1.5F, 1.0F), 0.75F);  // the brightness scales the offset too
}

TEST_F(Remap, IdentityIsExact) {
    for (int i = 0; i <= 100; ++i) {
        const float v = static_cast<float>(i) / 100.0F;
        EXPECT_EQ(remap(v, 0.0F, 1.0F, 1.0F), v);
    }
}

TEST_F(Remap, BrightnessOffsetAndContrastMoveTheResult) {
    const float plain = remap(0.5F, 0.0F, 1.0F, 1.0F);
    EXPECT_GT(remap(0.5F, 0.1F, 1.0F, 1.0F), plain);
    EXPECT_GT(remap(0.5F, 0.0F, 1.1F, 1.0F), plain);
    EXPECT_LT(remap(0.5F, 0.0F, 1.0F, 1.1F), plain);
}

TEST_F(Remap, Edges) {
    EXPECT_EQ(remap(0.1F, -0.5F, 1.0F, 2.0F), 0.0F);  // a negative base, whose power pow() does not define
    EXPECT_EQ(remap(0.0F, 0.0F, 1.0F, 2.0F), 0.0F);
    EXPECT_EQ(remap(0.0F, 0.0F, 1.0F, 0.0F), 1.0F);  // nor 0^0
    EXPECT_EQ(remap(0.1F, -0.5F, 1.0F, 0.0F), 1.0F);
    EXPECT_EQ(remap(0.9F, 0.5F, 2.0F, 1.0F), 1.0F);
    EXPECT_EQ(remap(0.5F, 0.0F, 1.0F, -1.0F), 1.0F);
    EXPECT_EQ(remap(infinity, 0.0F, 1.0F, 1.0F), 1.0F);
    EXPECT_EQ(remap(-infinity, 0.0F, 1.0F, 1.0F), 0.0F);
    EXPECT_EQ(remap(NAN, 0.0F, 1.0F, 1.0F), 1.0F);
    EXPECT_EQ(remap(0.5F, NAN, 1.0F, 1.0F), 1.0F);
    EXPECT_EQ(remap(0.5F, 0.0F, NAN, 1.0F), 1.0F);
    EXPECT_EQ(remap(0.5F, 0.0F, 1.0F, NAN), 1.0F);
}

}  // namespace gloam::shading_test
