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

// Pixels of one slice and one tap, whose place is noise, and of their blur: another one is another opponent.
TEST_F(PlainSlicesTest, KeepsItsPixels) {
    const scene::Scene scene = scene::make_scene("columns");
    const scene::GBuffer view = drawn(scene, extent);
    const PlainFrame frame = plain(view, scene.ao_radius, {.slices = 1, .steps = 1}, 1);
    constexpr auto known = std::to_array<std::tuple<std::size_t, float, float>>({{185, 0.4720F, 0.2349F},
                                                                                 {740, 0.5485F, 0.2414F},
                                                                                 {2294, 0.8658F, 0.6575F},
                                                                                 {3145, 0.7467F, 0.5493F},
                                                                                 {5106, 0.5138F, 0.3450F}});
    for (const auto& [pixel, occlusion, blurred] : known) {
        EXPECT_NEAR(frame.occlusion[pixel], occlusion, 1e-4) << pixel;
        EXPECT_NEAR(frame.blurred[pixel], blurred, 1e-4) << pixel;
    }
}

// A blur removes noise and keeps to the surface; the second one takes what the first has made.
TEST_F(PlainSlicesTest, BlursAsOftenAsAsked) {
    const scene::Scene scene = scene::make_scene("columns");
    const scene::GBuffer view = drawn(scene, extent);
    std::vector<PlainFrame> frames;
    for (const int blurs : {0, 1, 2}) {
        frames.push_back(plain(view, scene.ao_radius, {.slices = 1, .steps = 2}, blurs));
        EXPECT_EQ(frames.back().occlusion, frames.front().occlusion);
        EXPECT_EQ(frames.back().blur_ms > 0.0, blurs > 0);
    }
    EXPECT_EQ(frames[0].blurred, frames[0].occlusion);
    const Truth limit = truth_from(view, plain(view, scene.ao_radius, {.slices = 24, .steps = 12}).occlusion);
    EXPECT_LT(errors_of(frames[1].blurred, limit).rmse, 0.7 * errors_of(frames[1].occlusion, limit).rmse);
    EXPECT_LT(errors_of(frames[2].blurred, limit).rmse, errors_of(frames[1].blurred, limit).rmse);
    for (std::size_t i = 0; i < view.depth.size(); ++i) {
        const float most = std::isfinite(view.depth[i]) ? 1.0F : 0.0F;
        ASSERT_TRUE(frames[1].blurred[i] >= 0.0F && frames[1].blurred[i] <= most) << i;
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

constexpr gpu::Extent odd{83, 45};

TEST(Timestamps, TheirLackIsAnErrorThatNamesTheDevice) {
    expect_error<std::runtime_error>(
        [] { require_timestamps({.name = "sundial", .timestamp_period_ns = 0.0}); },
        {"sundial", "no timestamps"});
    EXPECT_NO_THROW(require_timestamps({.timestamp_period_ns = 1.0}));
}

// Passes are compiled so that what a loop does not change is computed before it, and short loops are
// unrolled: the same images, to the bit, as when it is computed in every round.

// A method of each kind of loop over samples. The passes of both kinds are compiled once for all of them.
class HoistedLoops : public OnDevice<testing::TestWithParam<std::string>> {
  protected:
    static void TearDownTestSuite() {
        written_.reset();
        OnDevice::TearDownTestSuite();
    }
    void SetUp() override {
        if (!written_) written_.emplace(device_, passes_.with(shader::Optimization::performance), odd);
    }

    // Two frames of a moving scene. converged: samples of a pixel that has; the loops are unrolled where they
    // are as many as all others take.
    [[nodiscard]] std::vector<Frame> frames(AmbientOcclusion& effect, std::uint32_t converged) const {
        const scene::Scene scene = scene::make_scene("moving");
        Settings settings = with_method(
            with_radius(preset_named("tssao-paper").settings, static_cast<float>(scene.ao_radius)),
            GetParam());
        settings.samples_converged = converged;
        effect.begin(drawn("moving", odd, {.frame = 0}), settings);
        std::vector<Frame> frames{effect.next()};
        effect.advance(drawn("moving", odd, {.frame = 1}));
        frames.push_back(effect.next());
        return frames;
    }

    inline static std::optional<AmbientOcclusion> written_;
};

TEST_P(HoistedLoops, ChangeNothing) {
    for (const std::uint32_t converged : {16U, 32U})
        expect_same_images(frames(effect_for(odd), converged), frames(*written_, converged),
                           {&Frame::occlusion, &Frame::filtered, &Frame::kept});
}

INSTANTIATE_TEST_SUITE_P(Methods, HoistedLoops,
                         testing::Values("hemisphere", "gtao", "poisson", "disc_proxy"),
                         [](const auto& asked) { return asked.param; });

}  // namespace gloam::effect::plain_slices_test
