// SPDX-License-Identifier: MIT
// The plain loop over slices: a fair opponent estimates what the method estimates.
#include "effect/study/plain_slices.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "effect/ambient_occlusion.hpp"
#include "effect/errors.hpp"
#include "effect/internal/method_families.hpp"
#include "effect/methods.hpp"
#include "on_device.hpp"
#include "scene/rasterize.hpp"

namespace gloam::effect {
namespace plain_slices_test {

constexpr gpu::Extent extent{96, 54};

// Of `gtao`, without history and filter, for a radius of 1.
Settings single_frame(SliceTaps taps) {
    Settings settings = slices(method_named("gtao"), taps.slices, taps.steps);
    settings.history = false;
    settings.filter = Filter::none;
    return settings;
}

class PlainSlicesTest : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] scene::GBuffer view_of(const scene::Scene& scene) const {
        return scene::rasterize(device_, passes_, scene, extent);
    }

    [[nodiscard]] PlainFrame plain(const scene::GBuffer& view, double radius, SliceTaps taps) const {
        PlainSlices slices(device_, passes_, view.extent, taps);
        slices.take(view, static_cast<float>(radius));
        return slices.next();
    }
};

// With many taps the two images differ by what a tap's pixel makes of them; with another radius by far more.
TEST_F(PlainSlicesTest, EstimatesWhatGtaoEstimates) {
    const scene::Scene scene = scene::make_scene("columns");
    const scene::GBuffer view = view_of(scene);
    const SliceTaps taps{.slices = 24, .steps = 12};
    const PlainFrame frame = plain(view, scene.ao_radius, taps);
    AmbientOcclusion effect(device_, passes_, extent);
    const auto difference = [&](double radius) {
        effect.begin(view, with_radius(single_frame(taps), static_cast<float>(radius)));
        return errors_of(effect.next().occlusion, truth_from(view, frame.occlusion)).rmse;
    };
    const double same = difference(scene.ao_radius);
    EXPECT_LT(same, 0.03);
    EXPECT_GT(difference(0.4 * scene.ao_radius), 2.0 * same);
}

TEST_F(PlainSlicesTest, TheBlurRemovesNoiseAndKeepsToTheSurface) {
    const scene::Scene scene = scene::make_scene("columns");
    const scene::GBuffer view = view_of(scene);
    const Truth limit = truth_from(view, plain(view, scene.ao_radius, {.slices = 24, .steps = 12}).occlusion);
    const PlainFrame frame = plain(view, scene.ao_radius, {.slices = 1, .steps = 2});
    EXPECT_LT(errors_of(frame.blurred, limit).rmse, 0.7 * errors_of(frame.occlusion, limit).rmse);
    for (std::size_t i = 0; i < view.depth.size(); ++i) {
        ASSERT_TRUE(frame.blurred[i] >= 0.0F && frame.blurred[i] <= 1.0F) << i;
        if (!std::isfinite(view.depth[i])) {
            EXPECT_EQ(frame.blurred[i], 0.0F) << i;
        }
    }
}

// The second blur takes what the first has made.
TEST_F(PlainSlicesTest, BlursAsOftenAsAsked) {
    const scene::Scene scene = scene::make_scene("columns");
    const scene::GBuffer view = view_of(scene);
    std::vector<PlainFrame> frames;
    for (const int blurs : {0, 1, 2}) {
        PlainSlices slices(device_, passes_, view.extent, {.slices = 1, .steps = 2}, blurs);
        slices.take(view, static_cast<float>(scene.ao_radius));
        frames.push_back(slices.next());
        EXPECT_EQ(frames.back().occlusion, frames.front().occlusion);
        EXPECT_EQ(frames.back().blur_ms > 0.0, blurs > 0);
    }
    EXPECT_EQ(frames[0].blurred, frames[0].occlusion);
    const Truth limit = truth_from(view, plain(view, scene.ao_radius, {.slices = 24, .steps = 12}).occlusion);
    EXPECT_LT(errors_of(frames[2].blurred, limit).rmse, errors_of(frames[1].blurred, limit).rmse);
}

TEST_F(PlainSlicesTest, WhatItDoesNotTakeIsRefused) {
    const scene::GBuffer view = view_of(scene::make_scene("columns"));
    EXPECT_THROW(PlainSlices(device_, passes_, extent, {.slices = 0, .steps = 2}), std::invalid_argument);
    EXPECT_THROW(PlainSlices(device_, passes_, extent, {}, -1), std::invalid_argument);
    PlainSlices slices(device_, passes_, extent, {});
    EXPECT_THROW(slices.take(view, 0.0F), std::invalid_argument);
    scene::GBuffer bare = view;
    bare.normal.clear();
    EXPECT_THROW(slices.take(bare, 1.0F), std::invalid_argument);
    scene::GBuffer parallel = view;
    parallel.camera.proj_vk[2][3] = 0.0F;
    EXPECT_THROW(slices.take(parallel, 1.0F), std::invalid_argument);
    PlainSlices smaller(device_, passes_, {16, 16}, {});
    EXPECT_THROW(smaller.take(view, 1.0F), std::invalid_argument);
}

}  // namespace plain_slices_test
}  // namespace gloam::effect
