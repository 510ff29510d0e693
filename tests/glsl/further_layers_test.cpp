// SPDX-License-Identifier: MIT
// Depth layers behind what the eye sees, in the loops over points, taps, pairs and slices.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "gathers.hpp"
#include "support/lab.hpp"

namespace gloam {
namespace {

using test::Camera;
using test::Gather;
using test::Method;
using test::Samples;

// Methods that see that many layers.
template <int layers>
class Layers : public testing::TestWithParam<const char*> {
  protected:
    test::MethodFunctions functions{layers};
    check::Lab lab = functions.lab();
    check::Kernel<Gather> gather{lab, functions.file(GetParam()), effect::method_function};

    // The mean of 256 samples at the middle of a floor at depth 5.
    [[nodiscard]] double mean(
        const test::Depths& first, const test::Depths& second,
        const test::Depths& third = [](glm::ivec2) { return 0.0F; }) const {
        const Camera camera{glm::vec2(0.5F, -0.5F), glm::ivec2(65), true};
        check::ImageSet images = test::view_of(camera.size, first);
        images.insert_or_assign("gloam_fetch_layers",
                                check::make_image<glm::vec3>(camera.size, [&](glm::ivec2 p) {
                                    return glm::vec3(second(p), third(p), 0);
                                }));
        images.insert_or_assign(
            "gloam_fetch_prepared",
            check::make_image<glm::vec4>(camera.size, [](glm::ivec2) { return glm::vec4(0); }));
        const Samples samples{.radius = 1.0F, .bias = 1e-4F, .angle = 0.0F, .first = 0, .count = 256};
        const Method method{.range = 1.5F, .steps = 16};
        const glm::vec2 sum =
            gather.with_images(images, {glm::vec3(0, 0, -5), glm::vec3(0, 0, 1), camera, samples, method});
        return static_cast<double>(sum.x / sum.y);
    }
};

class FurtherLayers : public Layers<2> {};
class ThreeLayers : public Layers<3> {};

// A tunnel whose sides rise beside the point; a fence hangs in front of them, too far to block anything.
float tunnel(glm::ivec2 p) {
    return std::abs(p.x - 32) > 4 ? 4.6F : 5.0F;
}
float fenced(glm::ivec2 p) {
    return std::abs(p.x - 32) > 4 ? 1.0F : 5.0F;
}
float back_of_fence(glm::ivec2 p) {
    return std::abs(p.x - 32) > 4 ? -1.1F : 0.0F;
}
float sides(glm::ivec2 p) {
    return std::abs(p.x - 32) > 4 ? 4.6F : 0.0F;
}
float bare(glm::ivec2) {
    return 5.0F;
}
float nothing(glm::ivec2) {
    return 0.0F;
}

// What the first layer hides blocks as if it were seen (CS-LAYERS).
TEST_P(FurtherLayers, ASecondLayerBlocksWhatTheFirstDoesNotShow) {
    const double seen = mean(tunnel, nothing);
    const double hidden = mean(fenced, nothing);
    ASSERT_GT(seen, hidden + 0.005);
    EXPECT_NEAR(mean(fenced, tunnel), seen, 1e-6);
}

// A layer that blocks less, or is not there, takes nothing away.
TEST_P(FurtherLayers, TheOneThatBlocksMostCounts) {
    const double seen = mean(tunnel, nothing);
    EXPECT_EQ(mean(tunnel, tunnel), seen);
    EXPECT_EQ(mean(tunnel, [](glm::ivec2) { return 7.0F; }), seen);
}

// A fence whose back is seen blocks nothing behind it: what the layer behind the back shows is all there is.
TEST_P(ThreeLayers, BehindTheBackOfAnObjectOnlyTheNextOneBlocks) {
    const double seen = mean(tunnel, nothing);
    const double open = mean(bare, nothing);
    ASSERT_GT(seen, open + 0.005);
    EXPECT_NEAR(mean(fenced, back_of_fence, sides), seen, 1e-6);
    EXPECT_NEAR(mean(fenced, back_of_fence, bare), open, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Points, ThreeLayers, testing::Values("hemisphere", "crytek", "filion"),
                         [](const auto& info) { return std::string(info.param); });

INSTANTIATE_TEST_SUITE_P(Loops, FurtherLayers,
                         testing::Values("hemisphere", "disc", "alchemy", "sao", "sao_chain", "issao",
                                         "aksoy_phaneuf", "gtao", "sweep", "hbao", "hbao_study", "bitmask",
                                         "volumetric", "hsao", "poisson", "ssdo", "unreal", "sphere_proxy",
                                         "mixture"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace gloam
