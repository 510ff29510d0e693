// SPDX-License-Identifier: MIT
// The frame of three short passes: as right as the presets, on every camera, size and encoding.
#include "effect/short_frame.hpp"
#include "effect/errors.hpp"
#include "effect/methods.hpp"
#include "on_device.hpp"
#include "surface_views.hpp"

namespace gloam::effect::short_frame_test {

constexpr gpu::Extent odd{83, 45};

class ShortFrames : public OnDevice<testing::TestWithParam<ShortSettings>> {
  protected:
    [[nodiscard]] Frame frame(const scene::GBuffer& view, double radius) const {
        ShortSettings exact = GetParam();
        exact.output = OutputFormat::r32f;
        return ShortFrame(device_, passes_).run(view, exact, static_cast<float>(radius));
    }
};

// The mean of a noisy frame is that of the presets' method with many slices, and follows the radius.
TEST_P(ShortFrames, EstimateWhatTheSweepEstimates) {
    const scene::GBuffer& view = rasterized("columns", {192, 108});
    for (const double radius : {1.0, 0.4}) {
        Settings many = with_radius(preset_named("reference").settings, static_cast<float>(radius));
        many.history = false;
        const Truth limit = truth_from(view, run(view, many).filtered);
        const Errors errors = errors_of(frame(view, radius).filtered, limit);
        EXPECT_LT(errors.rmse, 0.08);
        EXPECT_LT(std::abs(errors.bias), 0.02);
    }
}

// A bare plane is open, at any tilt, up to the rounding of depth to 16 bits. That counts most in a slice in
// which the normal is short.
TEST_P(ShortFrames, APlaneIsOpen) {
    for (const bool orthographic : {false, true})
        for (const glm::dvec3 normal : {glm::dvec3(0, 0, 1), {0.6, 0.3, 1}, {-0.4, 0.9, 1}})
            for (const float value : frame(plane(odd, orthographic, normal), 0.5).filtered)
                ASSERT_LE(value, 0.02F) << orthographic << ' ' << normal.x;
}

TEST_P(ShortFrames, PoisonedDepthStaysInRange) {
    scene::GBuffer view = rasterized("columns", odd);
    const float poison[] = {NAN, INFINITY, -INFINITY, 0.0F, -1.0F, 1e30F};
    for (std::size_t i = 0; i < view.depth.size(); i += 7) view.depth[i] = poison[i % std::size(poison)];
    for (std::size_t i = 0; i < view.normal.size(); i += 11) view.normal[i] = glm::vec3(poison[i % 4]);
    const std::vector<float> shown = frame(view, 1.0).filtered;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        ASSERT_TRUE(shown[i] >= 0.0F && shown[i] <= 1.0F) << i << ": " << shown[i];
        if (i % 7 == 0) {
            EXPECT_EQ(shown[i], 0.0F) << i;
        }
    }
}

TEST_P(ShortFrames, WhatTheyDoNotTakeIsRefused) {
    EXPECT_THROW((void)frame(rasterized("columns", odd), 0.0), std::invalid_argument);
    EXPECT_THROW((void)short_frame_named("frame-none"), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Names, ShortFrames, testing::ValuesIn(short_frames()), [](const auto& asked) {
    return asked.param.name.substr(asked.param.name.find('-') + 1);
});

}  // namespace gloam::effect::short_frame_test
