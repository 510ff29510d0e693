// SPDX-License-Identifier: MIT
// The lit image.
#include "effect/composite.hpp"

#include "on_device.hpp"

namespace gloam::effect::composite_test {

class CompositePass : public OnDevice<testing::Test> {
  protected:
    Composite composite_{device_, passes_};
};

// ISSAO-2 and direct light, in an image whose sides are no multiples of a group's.
TEST_F(CompositePass, OcclusionDarkensTheAmbientLightAlone) {
    const gpu::Extent extent{37, 21};
    const scene::GBuffer view = drawn("corner", extent, {.color = true});
    const scene::SplitLight light = scene::light_of(view, nullptr);
    const auto open = composite_.lit(extent, light, {});
    const auto quarter = composite_.lit(extent, light, std::vector<float>(open.size(), 0.25F));
    const auto closed = composite_.lit(extent, light, std::vector<float>(open.size(), 1.0F));
    ASSERT_EQ(open.size(), view.depth.size());
    float brightest = 0.0F;
    for (std::size_t i = 0; i < open.size(); ++i) {
        brightest = std::max(brightest, light.ambient[i].x);
        for (int c = 0; c < 3; ++c) {
            EXPECT_FLOAT_EQ(open[i][c], light.direct[i][c] + light.ambient[i][c]);
            EXPECT_FLOAT_EQ(quarter[i][c], light.direct[i][c] + 0.75F * light.ambient[i][c]);
            EXPECT_FLOAT_EQ(closed[i][c], light.direct[i][c]);
        }
    }
    EXPECT_GT(brightest, 0.1F);
}

// Each pixel has its own occlusion. Values outside [0, 1] are clamped, and NaN counts as 0.
TEST_F(CompositePass, EachPixelHasItsOwnOcclusion) {
    const scene::SplitLight light{.ambient = std::vector<glm::vec3>(5, glm::vec3(1, 2, 4)),
                                  .direct = std::vector<glm::vec3>(5, glm::vec3(0.5F, 0, 0))};
    const std::vector<float> occlusion{0.0F, 0.5F, 1.5F, -1.0F, nan};
    const auto lit = composite_.lit({5, 1}, light, occlusion);
    EXPECT_EQ(lit[0], glm::vec3(1.5F, 2, 4));
    EXPECT_EQ(lit[1], glm::vec3(1.0F, 1, 2));
    EXPECT_EQ(lit[2], glm::vec3(0.5F, 0, 0));
    EXPECT_EQ(lit[3], glm::vec3(1.5F, 2, 4));
    EXPECT_EQ(lit[4], glm::vec3(1.5F, 2, 4));
}

// GTAO-bounce in the place of ISSAO-2.
TEST_F(CompositePass, BrightBlockersSendLight) {
    const scene::SplitLight light{.ambient = std::vector<glm::vec3>(2, glm::vec3(1, 2, 4)),
                                  .direct = std::vector<glm::vec3>(2, glm::vec3(0.5F, 0, 0))};
    const auto lit = composite_.lit({2, 1}, light, std::vector<float>{0.5F, 0.0F},
                                    std::vector<glm::vec3>(2, {0, 0.5F, 1}));
    const glm::vec3 expected(0.5F + 0.5F, 2 * 0.68096F, 4 * 0.8979F);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(lit[0][c], expected[c], 5e-4F) << c;
    EXPECT_EQ(lit[1], glm::vec3(1.5F, 2, 4));
}

TEST_F(CompositePass, RefusesImagesOfAnotherSize) {
    const scene::SplitLight light{.ambient = std::vector<glm::vec3>(6), .direct = std::vector<glm::vec3>(6)};
    const auto with = [&](gpu::Extent extent, std::size_t occlusions) {
        return
            [&, extent, occlusions] { (void)composite_.lit(extent, light, std::vector<float>(occlusions)); };
    };
    EXPECT_THAT(with({3, 2}, 4), ThrowsMessage<std::invalid_argument>(HasSubstr("4 occlusions")));
    EXPECT_THAT(with({3, 3}, 0),
                ThrowsMessage<std::invalid_argument>(HasSubstr("6 pixels with ambient light")));
}

}  // namespace gloam::effect::composite_test
