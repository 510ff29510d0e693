// SPDX-License-Identifier: MIT
#include "effect/ambient_occlusion.hpp"

#include "effect/errors.hpp"
#include "effect/methods.hpp"
#include "on_device.hpp"
#include "scene/analytic_scene.hpp"
#include "surface_views.hpp"

namespace gloam::effect::ambient_occlusion_test {

// Opens the device with validation, and fails on any message.
class Effect : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] scene::GBuffer corner(gpu::Extent extent) const { return drawn("corner", extent); }
};

Settings settings_for(float radius) {
    return with_radius(preset_named("tssao-paper").settings, radius);
}

// The background around a window of geometry, and the radius below a pixel far behind it.
TEST_F(Effect, SkippingLeavesTheOtherPixelsAsTheyWere) {
    scene::GBuffer view = corner({64, 36});
    for (std::size_t i = 0; i < view.depth.size(); ++i) {
        if (i % 64 < 20) view.depth[i] = infinity;
        if (i % 64 >= 44) view.depth[i] = 1e5F;
    }
    Settings skip = settings_for(1.0F);
    Settings all = skip;
    all.least_radius = 0.0F;
    const Frame with = run(view, skip, 2);
    const Frame without = run(view, all, 2);
    for (std::size_t i = 0; i < view.depth.size(); ++i) {
        if (i % 64 >= 44) {
            EXPECT_EQ(with.occlusion[i], 0.0F) << i;
            EXPECT_EQ(with.convergence[i], 1.0F) << i;
            continue;
        }
        EXPECT_EQ(with.occlusion[i], without.occlusion[i]) << i;
        EXPECT_EQ(with.filtered[i], without.filtered[i]) << i;
    }
}

TEST_F(Effect, OneFrameOrManyOfTheSameSamples) {
    const scene::GBuffer view = corner({64, 36});
    Settings settings = settings_for(1.0F);
    settings.c_rot = 0.0F;
    settings.samples = 64;
    const Frame one = run(view, settings, 1);
    settings.samples = 8;
    const Frame many = run(view, settings, 8);
    for (std::size_t i = 0; i < one.occlusion.size(); ++i) {
        ASSERT_NEAR(one.occlusion[i], many.occlusion[i], 1e-6) << i;
        ASSERT_EQ(one.convergence[i], many.convergence[i]) << i;
    }
}

// An estimate of n yes-or-no samples has a standard deviation of at most 1 / (2 sqrt(n)); Halton points do
// better. More samples help, and so does the filter.
TEST_F(Effect, TheCornerComesCloseToItsClosedForm) {
    const scene::GBuffer view = corner({160, 90});
    const Truth truth = truth_of(view, 1.0, scene::corner_occlusion_at);
    Settings settings = settings_for(1.0F);
    const Frame one = run(view, settings, 1);
    const Frame many = run(view, settings, 16);
    const Errors rough = errors_of(one.occlusion, truth);
    EXPECT_GT(rough.compared, 3000U);
    EXPECT_LT(rough.rmse, 0.5 / std::sqrt(32.0));
    EXPECT_LT(errors_of(one.filtered, truth).rmse, 0.75 * rough.rmse);
    EXPECT_LT(errors_of(many.occlusion, truth).rmse, 0.5 / std::sqrt(512.0));
    EXPECT_LT(std::abs(errors_of(many.occlusion, truth).bias), 0.01);
}

TEST_F(Effect, WhatCannotBeIsRefused) {
    const scene::GBuffer view = wall({8, 8}, 3.0F);
    AmbientOcclusion effect(device_, passes_, {8, 8});
    EXPECT_THROW((void)effect.next(), std::logic_error);
    EXPECT_THROW((AmbientOcclusion{device_, passes_, {0, 0}}), std::runtime_error);
    using Change = std::function<void(scene::GBuffer&, Settings&)>;
    const std::vector<std::pair<Change, const char*>> rows{
        {[](scene::GBuffer& changed, Settings&) { changed = wall({8, 7}, 3.0F); }, ""},
        {[](scene::GBuffer&, Settings& settings) { settings.radius = nan; }, "radius"},
        {[](scene::GBuffer&, Settings& settings) { settings.guard = 0.1F; }, "no guard band"},
        {[](scene::GBuffer& changed, Settings&) { changed.off_centre = {4, 0}; }, "centred"},
        {[](scene::GBuffer& changed, Settings&) { changed.border = gpu::Extent{4, 0}; }, "no frame"},
        {[](scene::GBuffer&, Settings& settings) { settings.own.layers = 2; }, "layers 2: the view has 1"},
        {[](scene::GBuffer& changed, Settings&) { changed.layers = {{1.0F}}; }, ""},
        {[](scene::GBuffer& changed, Settings&) { changed.layers.assign(4, changed.depth); }, ""}};
    for (const auto& [change, named] : rows) {
        scene::GBuffer changed = view;
        Settings settings = settings_for(1.0F);
        change(changed, settings);
        expect_error<std::invalid_argument>([&] { effect.begin(changed, settings); }, {named});
    }
}

}  // namespace gloam::effect::ambient_occlusion_test
