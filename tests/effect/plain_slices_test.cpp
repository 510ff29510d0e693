// SPDX-License-Identifier: MIT
// The plain loop over slices: a fair opponent estimates what the method estimates.
#include <fmt/format.h>

#include "effect/errors.hpp"
#include "effect/internal/method_families.hpp"
#include "effect/study/plain_slices.hpp"
#include "module/compile.hpp"
#include "on_device.hpp"
#include "surface_views.hpp"

namespace gloam::effect::plain_slices_test {

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
    [[nodiscard]] PlainFrame plain(const scene::GBuffer& view, double radius, SliceTaps taps,
                                   int blurs = 0) const {
        PlainSlices slices(device_, passes_, view.extent, taps, blurs);
        slices.take(view, static_cast<float>(radius));
        return slices.next();
    }
};

// With many taps the two images differ by what a tap's pixel makes of them; with another radius by far more.
TEST_F(PlainSlicesTest, EstimatesWhatGtaoEstimates) {
    const scene::Scene scene = scene::make_scene("columns");
    const scene::GBuffer view = drawn(scene, extent);
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

// Pixels of one slice and one tap, whose place is noise, and of their blurs: another one is another opponent.
TEST_F(PlainSlicesTest, KeepsItsPixels) {
    const scene::Scene scene = scene::make_scene("columns");
    const scene::GBuffer view = drawn(scene, extent);
    constexpr auto known =
        std::to_array<std::tuple<std::size_t, std::array<float, 3>>>({{185, {0.4720F, 0.2349F, 0.2209F}},
                                                                      {740, {0.5485F, 0.2414F, 0.2060F}},
                                                                      {2294, {0.8658F, 0.6575F, 0.5612F}},
                                                                      {3145, {0.7467F, 0.5493F, 0.4403F}},
                                                                      {5106, {0.5138F, 0.3450F, 0.2875F}}});
    for (const int blurs : {0, 1, 2}) {
        const PlainFrame frame = plain(view, scene.ao_radius, {.slices = 1, .steps = 1}, blurs);
        EXPECT_EQ(frame.blur_ms > 0.0, blurs > 0);
        for (const auto& [pixel, shown] : known) {
            EXPECT_NEAR(frame.occlusion[pixel], shown[0], 1e-4) << pixel;
            EXPECT_NEAR(frame.blurred[pixel], shown.at(blurs), 1e-4) << pixel << ' ' << blurs;
        }
    }
}

TEST_F(PlainSlicesTest, WhatItDoesNotTakeIsRefused) {
    const scene::GBuffer view = drawn("columns", extent);
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

TEST(Timestamps, TheirLackIsAnErrorThatNamesTheDevice) {
    expect_error<std::runtime_error>(
        [] { require_timestamps({.name = "sundial", .timestamp_period_ns = 0.0}); },
        {"sundial", "no timestamps"});
    EXPECT_NO_THROW(require_timestamps({.timestamp_period_ns = 1.0}));
}

// Passes are compiled so that what a loop does not change is computed before it, and short loops are
// unrolled: the same images, to the bit, as when it is computed in every round.

using HoistedLoops = OnDevice<testing::Test>;

// A method of each kind of loop over samples, two frames of a moving scene. The loops are unrolled where a
// pixel that has converged takes as many samples as all others.
TEST_F(HoistedLoops, ChangeNothing) {
    constexpr gpu::Extent odd{83, 45};
    const std::vector<scene::GBuffer> views{drawn("moving", odd), drawn("moving", odd, {.frame = 1})};
    AmbientOcclusion written(device_, passes_.with(shader::Optimization::performance), odd);
    for (const char* method : {"hemisphere", "gtao", "poisson", "disc_proxy"})
        for (const char* converged : {" samples_converged=16", " samples_converged=32"}) {
            const Settings settings =
                with(Settings{}, "radius=0.5 method=" + (method + std::string(converged)));
            const std::vector<Frame> hoisted = run(views, settings);
            written.begin(views[0], settings);
            expect_same_images(hoisted[0], written.next());
            written.advance(views[1]);
            expect_same_images(hoisted[1], written.next());
        }
}

}  // namespace gloam::effect::plain_slices_test
