// SPDX-License-Identifier: MIT
// Half the resolution and back: what holds of any depths.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "numeric/random.hpp"
#include "support/lab.hpp"

namespace gloam {
namespace upsample_test {

using check::Kernel;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr const char* file = "gloam/filter/upsample.glsl";

class Upsample : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
    const Kernel<float(float, glm::vec4, glm::vec4, bool)> upsample{lab, file, "gloam_upsample"};
    const Kernel<bool(float, float, float, bool)> continues{lab, file, "gloam_upsample_continues"};
};

// Through any three pixels in a row of a plane, however steep, the surface continues; through a step of 1.3 %
// of the depth it does not.
TEST_F(Upsample, PlanesContinueAndStepsDoNot) {
    for (const float slope : {0.0F, 0.01F, 0.3F, 0.9F}) {
        const auto depth = [&](float x) { return 1.0F / (1.0F + slope * x); };  // perspective
        EXPECT_TRUE(continues(depth(0), depth(-1), depth(1), false)) << slope;
        EXPECT_TRUE(continues(1.0F, 1.0F - slope, 1.0F + slope, true)) << slope;
    }
    for (const bool orthographic : {false, true}) {
        EXPECT_FALSE(continues(1.0F, 1.0F, 1.013F, orthographic));
        EXPECT_FALSE(continues(1.0F, 1.0F, 0.987F, orthographic));
        EXPECT_FALSE(continues(1.0F, 1.013F, 1.013F, orthographic));
        EXPECT_FALSE(continues(1.0F, infinity, 1.0F, orthographic));
        EXPECT_FALSE(continues(infinity, infinity, infinity, orthographic));
        EXPECT_FALSE(continues(1.0F, NAN, 1.0F, orthographic));
    }
    EXPECT_FALSE(continues(1.0F, 0.5F, 1.5F, false)) << "not a plane of a perspective camera";
    EXPECT_TRUE(continues(1.0F, 0.5F, 1.5F, true));
}

// What is on the pixel's surface counts, and only that.
TEST_F(Upsample, OnlyTheSurfaceOfThePixelCounts) {
    const glm::vec4 occlusions(0.1F, 0.3F, 0.5F, 0.9F);
    const auto at = [&](glm::vec4 depths) { return upsample(2.0F, depths, occlusions, false); };
    EXPECT_NEAR(at(glm::vec4(2)), 0.45F, 1e-6F);
    EXPECT_NEAR(at(glm::vec4(2, 2, 2, 4)), 0.4F, 1e-6F) << "the pair of y and z";
    EXPECT_NEAR(at(glm::vec4(2, 1, 2, 2)), 0.5F, 1e-6F) << "the pair of x and w";
    EXPECT_EQ(at(glm::vec4(4, 4, 2.1F, 4)), 0.5F) << "the nearest";
    EXPECT_EQ(at(glm::vec4(1.9F, 4, 4, 4)), 0.1F);
    EXPECT_EQ(at(glm::vec4(infinity, 4, 0, NAN)), 0.3F);
    EXPECT_EQ(at(glm::vec4(infinity)), 0.0F);
    EXPECT_EQ(upsample(infinity, glm::vec4(2), occlusions, false), 0.0F);
    EXPECT_EQ(upsample(2.0F, glm::vec4(2), glm::vec4(NAN), false), 0.0F);
    EXPECT_EQ(upsample(2.0F, glm::vec4(2), glm::vec4(5), false), 1.0F);
}

TEST_F(Upsample, AConstantStays) {
    numeric::Random random(7);
    for (int i = 0; i < 200; ++i) {
        const auto value = static_cast<float>(random.uniform(0, 1));
        glm::vec4 depths(0);
        for (int k = 0; k < 4; ++k)
            depths[k] = static_cast<float>(random.uniform(0.99, i % 2 == 0 ? 1.01 : 3.0));
        EXPECT_EQ(upsample(1.0F, depths, glm::vec4(value), i % 3 == 0), value);
    }
}

}  // namespace upsample_test
}  // namespace gloam
