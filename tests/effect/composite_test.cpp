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
    const auto& [ambient, direct] = std::pair(view.color, view.normal);  // any light
    for (const float occlusion : {0.0F, 0.25F, 1.0F}) {
        const auto lit = composite_.lit(extent, ambient, direct, std::vector(ambient.size(), occlusion));
        ASSERT_EQ(lit.size(), ambient.size());
        for (std::size_t i = 0; i < lit.size(); ++i)
            for (int c = 0; c < 3; ++c)
                EXPECT_FLOAT_EQ(lit[i][c], direct[i][c] + (1.0F - occlusion) * ambient[i][c]);
    }
    EXPECT_EQ(composite_.lit(extent, ambient, direct, {}),
              composite_.lit(extent, ambient, direct, std::vector(ambient.size(), 0.0F)));
}

// Each pixel has its own occlusion. Values outside [0, 1] are clamped, and NaN counts as 0.
TEST_F(CompositePass, EachPixelHasItsOwnOcclusion) {
    const std::vector<glm::vec3> ambient(5, {1, 2, 4});
    const std::vector<glm::vec3> direct(5, {0.5F, 0, 0});
    const auto lit = composite_.lit({5, 1}, ambient, direct, std::vector{0.0F, 0.5F, 1.5F, -1.0F, nan});
    EXPECT_EQ(lit[0], glm::vec3(1.5F, 2, 4));
    EXPECT_EQ(lit[1], glm::vec3(1.0F, 1, 2));
    EXPECT_EQ(lit[2], glm::vec3(0.5F, 0, 0));
    EXPECT_EQ(lit[3], glm::vec3(1.5F, 2, 4));
    EXPECT_EQ(lit[4], glm::vec3(1.5F, 2, 4));
}

// GTAO-bounce in the place of ISSAO-2.
TEST_F(CompositePass, BrightBlockersSendLight) {
    const std::vector<glm::vec3> ambient(2, {1, 2, 4});
    const std::vector<glm::vec3> direct(2, {0.5F, 0, 0});
    const auto lit = composite_.lit({2, 1}, ambient, direct, std::vector<float>{0.5F, 0.0F},
                                    std::vector<glm::vec3>(2, {0, 0.5F, 1}));
    const glm::vec3 expected(0.5F + 0.5F, 2 * 0.68096F, 4 * 0.8979F);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(lit[0][c], expected[c], 5e-4F) << c;
    EXPECT_EQ(lit[1], glm::vec3(1.5F, 2, 4));
}

TEST_F(CompositePass, RefusesImagesOfAnotherSize) {
    const std::vector<glm::vec3> light(6);
    const auto with = [&](gpu::Extent extent, std::size_t occlusions) {
        return [&, extent, occlusions] {
            (void)composite_.lit(extent, light, light, std::vector<float>(occlusions));
        };
    };
    EXPECT_THAT(with({3, 2}, 4), ThrowsMessage<std::invalid_argument>(HasSubstr("4 occlusions")));
    EXPECT_THAT(with({3, 3}, 0),
                ThrowsMessage<std::invalid_argument>(HasSubstr("6 pixels with ambient light")));
}

}  // namespace gloam::effect::composite_test
