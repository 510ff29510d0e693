// SPDX-License-Identifier: MIT
// More than one depth image, more than one resolution, more than one pass, more than one frame.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/lab.hpp"

namespace gloam {
namespace layers_test {

using check::Kernel;

constexpr float infinity = std::numeric_limits<float>::infinity();
const glm::vec3 up(0, 0, 1);

class Layers : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
};

TEST_F(Layers, LargestOcclusion) {
    const Kernel<float(float, float)> over(lab, "gloam/occlusion/layers.glsl", "gloam_layers_occlusion");
    EXPECT_EQ(over(0.0F, 0.25F), 0.25F);
    EXPECT_EQ(over(0.25F, 0.25F), 0.25F);  // the same layer twice
    EXPECT_EQ(over(0.5F, 0.25F), 0.5F);
    EXPECT_EQ(over(0.5F, NAN), 0.5F);
    EXPECT_EQ(over(NAN, 0.5F), 0.5F);
    EXPECT_EQ(over(0.5F, 2.0F), 1.0F);
}

TEST_F(Layers, BetweenFrontAndBack) {
    const Kernel<float(float, float, float)> blocked(lab, "gloam/occlusion/layers.glsl",
                                                     "gloam_layer_blocked");
    EXPECT_EQ(blocked(2.5F, 2.0F, 3.0F), 1.0F);
    EXPECT_EQ(blocked(2.0F, 2.0F, 3.0F), 1.0F);
    EXPECT_EQ(blocked(3.0F, 2.0F, 3.0F), 1.0F);
    EXPECT_EQ(blocked(1.9F, 2.0F, 3.0F), 0.0F);
    EXPECT_EQ(blocked(3.1F, 2.0F, 3.0F), 0.0F);  // open space behind a thin object
    for (const float background : {infinity, 0.0F, -1.0F, NAN}) {
        EXPECT_EQ(blocked(30.0F, 2.0F, background), 1.0F);
        EXPECT_EQ(blocked(2.5F, background, 3.0F), 0.0F);
        EXPECT_EQ(blocked(background, 2.0F, infinity), 0.0F);
    }
}

// As in gloam/gather/pair.glsl.
struct PairShare {
    float occluded;
    float whole;
};

// Of the layers tried at a pair of taps one stays that is a surface and does not block less, as a share.
TEST_F(Layers, ATryStaysThatBlocksAtLeastAsMuch) {
    const Kernel<bool(glm::vec2, int, int, PairShare, PairShare)> kernel(lab, "gloam/gather/pair.glsl",
                                                                         "gloam_pair_stays");
    const check::ImageSet unread{
        {"gloam_fetch_depth", check::make_image<float>({1, 1}, [](glm::ivec2) { return 0.0F; })},
        {"gloam_fetch_layers",
         check::make_image<glm::vec3>({1, 1}, [](glm::ivec2) { return glm::vec3(0); })}};
    const auto stays = [&](glm::vec2 depths, int look, int layers, PairShare found, PairShare most) {
        return kernel.with_images(unread, {depths, look, layers, found, most});
    };
    const PairShare half{1, 2};
    const PairShare unusable{0, 0};
    const glm::vec2 both(3, 4);
    EXPECT_TRUE(stays(glm::vec2(0), 0, 2, unusable, half));  // the visible surfaces
    for (const int look : {1, 2}) {
        EXPECT_TRUE(stays(both, look, 2, PairShare{0.75F, 1}, half));
        EXPECT_TRUE(stays(both, look, 2, PairShare{2, 4}, half));
        EXPECT_FALSE(stays(both, look, 2, PairShare{1.9F, 4}, half));
        EXPECT_TRUE(stays(both, look, 2, PairShare{0, 1}, unusable));
        EXPECT_FALSE(stays(both, look, 2, unusable, unusable));
        // At the first tap, then at the second, there is no such layer.
        EXPECT_EQ(stays(glm::vec2(0, 4), look, 2, PairShare{2, 1}, half), look == 2);
        EXPECT_EQ(stays(glm::vec2(3, 0), look, 2, PairShare{2, 1}, half), look == 1);
    }
}

TEST_F(Layers, DepthRejection) {
    const Kernel<bool(float, float, float)> rejected(lab, "gloam/occlusion/depth_rejection.glsl",
                                                     "gloam_tap_rejected");
    EXPECT_TRUE(rejected(5.0F, 3.5F, 1.0F));
    EXPECT_FALSE(rejected(5.0F, 4.0F, 1.0F));
    EXPECT_FALSE(rejected(5.0F, 3.5F, 2.0F));
    EXPECT_FALSE(rejected(5.0F, 50.0F, 1.0F));
    for (const float background : {infinity, 0.0F, -1.0F, NAN}) {
        EXPECT_FALSE(rejected(5.0F, background, 1.0F));
        EXPECT_FALSE(rejected(background, 3.5F, 1.0F));
    }
    EXPECT_FALSE(rejected(5.0F, 3.5F, NAN));
}

class DualResolution : public Layers {
  protected:
    Kernel<bool(glm::ivec2, glm::ivec2, float)> disagrees{lab, "gloam/filter/dual_resolution.glsl",
                                                          "gloam_dual_resolution_disagrees"};

    // An even image with one other value at (3, 2).
    bool at(glm::ivec2 pixel, float other, float tolerance, glm::ivec2 size = {5, 5}) const {
        const auto value = [&](glm::ivec2 p) { return p == glm::ivec2(3, 2) ? other : 0.25F; };
        return disagrees.with_images({{"gloam_fetch_occlusion", check::make_image<float>(size, value)}},
                                     {pixel, size, tolerance});
    }
};

TEST_F(DualResolution, LooksAtThreeByThree) {
    EXPECT_TRUE(at({2, 2}, 0.5F, 0.1F));
    EXPECT_TRUE(at({4, 3}, 0.5F, 0.1F));
    EXPECT_FALSE(at({1, 2}, 0.5F, 0.1F));
    EXPECT_FALSE(at({3, 4}, 0.5F, 0.1F));
    EXPECT_FALSE(at({2, 2}, 0.5F, 0.25F));
    EXPECT_TRUE(at({2, 2}, 0.5F, 0.24F));
    EXPECT_FALSE(at({0, 0}, 0.5F, 0.1F, {1, 1}));
    EXPECT_FALSE(at({0, 0}, 0.5F, 0.0F, {3, 1}));
    EXPECT_TRUE(at({2, 2}, NAN, 0.5F));
    EXPECT_TRUE(at({0, 0}, 0.25F, NAN));
}

TEST_F(Layers, SeparableForms) {
    const std::string file = "gloam/occlusion/separable.glsl";
    const Kernel<float(float, float)> mean(lab, file, "gloam_separable_mean");
    EXPECT_EQ(mean(0.5F, 0.0F), 0.25F);  // a wall along v
    EXPECT_EQ(mean(0.0F, 0.5F), 0.25F);  // turned by 90 degrees
    EXPECT_EQ(mean(1.0F, 1.0F), 1.0F);
    EXPECT_EQ(mean(NAN, 1.0F), 0.5F);
    const Kernel<float(glm::vec3, glm::vec3, float, float)> weight(lab, file, "gloam_separable_weight");
    EXPECT_EQ(weight(glm::vec3(0), up, 1.0F, 0.1F), 1.0F);
    EXPECT_NEAR(weight(glm::vec3(1, 0, 0), up, 1.0F, 0.1F), std::exp(-0.5), 1e-6);
    EXPECT_NEAR(weight(glm::vec3(1, 0, 0), up, 2.0F, 0.1F), std::exp(-0.125), 1e-6);
    EXPECT_EQ(weight(glm::vec3(1, 0, 0.2F), up, 1.0F, 0.1F), 0.0F);
    EXPECT_EQ(weight(glm::vec3(1, 0, -0.2F), up, 1.0F, 0.1F), 0.0F);
    EXPECT_GT(weight(glm::vec3(1, 0, 0.2F), up, 1.0F, 0.3F), 0.0F);
    EXPECT_EQ(weight(glm::vec3(NAN), up, 1.0F, 0.1F), 0.0F);
    EXPECT_EQ(weight(glm::vec3(infinity, 0, 0), up, 1.0F, infinity), 0.0F);
}

// m frames of x after y leave x + (y - x) (1 - rate)^m.
TEST_F(Layers, ExponentialMeanOverFrames) {
    const Kernel<float(float, bool, float, float)> smooth(lab, "gloam/temporal/smoothing.glsl",
                                                          "gloam_temporal_smooth");
    float value = 0.9F;
    for (int m = 1; m <= 12; ++m) {
        value = smooth(value, true, 0.2F, 0.25F);
        EXPECT_NEAR(value, 0.2 + 0.7 * std::pow(0.75, m), 1e-6);
    }
    EXPECT_EQ(smooth(0.9F, false, 0.2F, 0.25F), 0.2F);
    EXPECT_EQ(smooth(NAN, true, 0.2F, 0.25F), 0.2F);
    EXPECT_EQ(smooth(0.9F, true, NAN, 0.25F), 0.9F);
    EXPECT_EQ(smooth(0.9F, false, NAN, 0.25F), 0.0F);
    EXPECT_EQ(smooth(0.9F, true, 0.2F, 0.0F), 0.9F);
    EXPECT_EQ(smooth(0.9F, true, 0.2F, 1.0F), 0.2F);
    EXPECT_EQ(smooth(0.9F, true, 0.2F, NAN), 0.2F);
}

}  // namespace layers_test
}  // namespace gloam
