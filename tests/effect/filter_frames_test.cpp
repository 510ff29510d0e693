// SPDX-License-Identifier: MIT
// A filter that runs in the first frames after a cut alone: until then the frames are those of a filter that
// always runs, and from then on those without a filter, to the bit.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/methods.hpp"
#include "effect/plan.hpp"
#include "on_device.hpp"
#include "scene/rasterize.hpp"

namespace gloam::effect::filter_frames_test {

constexpr gpu::Extent extent{83, 45};
constexpr std::size_t filtered_frames = 3;

class FilterFrames : public OnDevice<testing::Test> {
  protected:
    static Settings settings_of(Filter filter, float frames) {
        Settings settings = with_radius(with_method(preset_named("balanced").settings, "alchemy"),
                                        static_cast<float>(scene::make_scene("moving").ao_radius));
        settings.filter = filter;
        settings.filter_frames = frames;
        settings.remap_b = 0.9F;  // the remapped images have skips of their own
        return settings;
    }

    [[nodiscard]] scene::GBuffer view(int frame) const {
        return rasterized("moving", extent, {.frame = frame, .motion = true});
    }

    // Frames of a camera that moves, then stands still until nothing changes, then is cut.
    [[nodiscard]] std::vector<Frame> run(const Settings& settings) const {
        AmbientOcclusion& effect = effect_for(extent);
        std::vector<Frame> frames;
        effect.begin(view(0), settings);
        frames.push_back(effect.next());
        for (int i = 1; i < 3; ++i) {
            effect.advance(view(i));
            frames.push_back(effect.next());
        }
        for (int i = 0; i < 4; ++i) frames.push_back(effect.next(2));
        effect.begin(view(1), settings);
        for (int i = 0; i < 5; ++i) frames.push_back(effect.next());
        return frames;
    }

    void expect_switch(Settings first) const {
        const std::vector<Frame> found = run(first);
        first.filter_frames = every_frame;
        const std::vector<Frame> always = run(first);
        first.filter = Filter::none;
        const std::vector<Frame> never = run(first);
        constexpr std::size_t cut = 7;
        for (std::size_t i = 0; i < found.size(); ++i) {
            SCOPED_TRACE(i);
            const bool filtered = i % cut < filtered_frames;
            const bool full = first.resolution == Resolution::full;
            if (full) expect_same_images(found[i], never[i], {&Frame::occlusion});
            expect_same_images(found[i], (filtered ? always : never)[i], {&Frame::filtered});
            EXPECT_TRUE(filtered || found[i].work.tiles_filtered == 0);
            EXPECT_FALSE(filtered && bits_of(always[i].filtered) == bits_of(never[i].filtered));
        }
    }
};

TEST_F(FilterFrames, AreTheFirstAfterACut) {
    expect_switch(settings_of(Filter::convergence, static_cast<float>(filtered_frames)));
}

// Tiles that have settled are left out of the frame in which the filter stops, and show what is not filtered.
TEST_F(FilterFrames, EndInASettledViewAsWell) {
    Settings settings = settings_of(Filter::bilateral, static_cast<float>(filtered_frames));
    settings.freeze = true;
    settings.weight_max = 3.0F;  // one frame's samples
    expect_switch(settings);
}

TEST_F(FilterFrames, AreTheFirstAtHalfTheResolutionAsWell) {
    Settings settings = settings_of(Filter::convergence, static_cast<float>(filtered_frames));
    settings.resolution = Resolution::half;
    expect_switch(settings);
    std::vector<std::string> turns;
    for (const PlannedPass& pass : plan_of(settings, {.tiles = true}).passes)
        if (pass.name.starts_with("upsample"))
            turns.push_back(pass.name + (pass.turn == Turn::early ? " early" : ""));
    EXPECT_EQ(turns, (std::vector<std::string>{"upsample", "upsample_filtered early"}));
}

TEST_F(FilterFrames, ArePlanned) {
    for (const bool remapped : {false, true}) {
        Settings settings = preset_named("balanced").settings;
        settings.filter_frames = 2.5F;
        settings.output = remapped ? OutputFormat::r8 : OutputFormat::r32f;
        const Plan plan = plan_of(settings, {.tiles = true});
        EXPECT_EQ(plan.filter_frames, 3U);
        EXPECT_EQ(plan.result, remapped ? "filtered_mapped" : "filtered");
        EXPECT_EQ(plan.later_result, remapped ? "mapped" : "history_after");
        EXPECT_EQ(plan.result_unit, 1.0F);
        EXPECT_EQ(plan.later_unit == 1.0F, remapped);
        for (const PlannedPass& pass : plan.passes) {
            const bool of_filter = pass.name.find("filter") != std::string::npos;
            EXPECT_EQ(pass.turn == Turn::early, of_filter) << pass.name;
        }
    }
    EXPECT_EQ(plan_of(preset_named("tssao-paper").settings, {}).filter_frames, 0U);
}

}  // namespace gloam::effect::filter_frames_test
