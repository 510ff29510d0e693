// SPDX-License-Identifier: MIT
#include "effect/ambient_occlusion.hpp"

#include "effect/methods.hpp"
#include "on_device.hpp"
#include "surface_views.hpp"

namespace gloam::effect::ambient_occlusion_test {

using Effect = OnDevice<testing::Test>;

Settings settings_for(float radius) {
    return with_radius(preset_named("tssao-paper").settings, radius);
}

// The background around a window of geometry, and the radius below a pixel far behind it.
TEST_F(Effect, SkippingLeavesTheOtherPixelsAsTheyWere) {
    scene::GBuffer view = drawn("corner", {64, 36});
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
