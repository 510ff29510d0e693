// SPDX-License-Identifier: MIT
// The plain loop over slices.
#include "effect/study/plain_slices.hpp"

#include "on_device.hpp"

namespace gloam::effect::plain_slices_test {

constexpr backend::Extent extent{96, 54};

using PlainSlicesTest = OnDevice<testing::Test>;

// Raw and blurred, of two slices of three taps: another number of them, or another blur, is another opponent.
TEST_F(PlainSlicesTest, KeepsItsPixels) {
    const scene::Scene scene = scene::make_scene("columns");
    constexpr auto known =
        std::to_array<std::tuple<std::size_t, std::array<float, 3>>>({{185, {0.1064F, 0.0488F, 0.0573F}},
                                                                      {740, {0.0654F, 0.0470F, 0.0425F}},
                                                                      {2294, {0.1473F, 0.1119F, 0.0995F}},
                                                                      {3145, {0.0480F, 0.0446F, 0.0473F}},
                                                                      {5106, {0.0F, 0.0679F, 0.0685F}}});
    for (const int blurs : {0, 1, 2}) {
        PlainSlices slices(device_, passes_, extent, {.slices = 2, .steps = 3}, blurs);
        slices.take(drawn("columns", extent), static_cast<float>(scene.ao_radius));
        const PlainFrame frame = slices.next();
        EXPECT_EQ(frame.blur_ms > 0.0, blurs > 0);
        for (const auto& [pixel, shown] : known) {
            EXPECT_NEAR(frame.occlusion[pixel], shown[0], 1e-4) << pixel;
            EXPECT_NEAR(frame.blurred[pixel], shown.at(blurs), 1e-4) << pixel << ' ' << blurs;
        }
    }
}

TEST_F(PlainSlicesTest, AnOrthographicCameraIsRefused) {
    scene::GBuffer parallel = drawn("columns", extent);
    parallel.camera.proj_vk[2][3] = 0.0F;
    PlainSlices slices(device_, passes_, extent, {});
    EXPECT_THROW(slices.take(parallel, 1.0F), std::invalid_argument);
}

TEST(Timestamps, TheirLackIsAnErrorThatNamesTheDevice) {
    expect_error<std::runtime_error>(
        [] { require_timestamps({.name = "sundial", .timestamp_period_ns = 0.0}); },
        {"sundial", "no timestamps"});
    EXPECT_NO_THROW(require_timestamps({.timestamp_period_ns = 1.0}));
}

}  // namespace gloam::effect::plain_slices_test
