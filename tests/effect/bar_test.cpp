// SPDX-License-Identifier: MIT
// The preset `fast` over the frames of a moving camera, against single frames of plain slices.
#include "effect/study/bar_study.hpp"

#include <gtest/gtest.h>

#include "effect/presets.hpp"
#include "on_device.hpp"

namespace gloam::effect {
namespace bar_test {

Settings preset_for(const char* name, const scene::Scene& scene) {
    return with_radius(preset_named(name).settings, static_cast<float>(scene.ao_radius));
}

class BarTest : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] Bar bar_of(const char* name, const BenchmarkFrames& frames) const {
        const scene::Scene scene = scene::make_scene(name);
        BenchmarkViews views(device_, passes_, scene, frames, scene::TruthCache(""));
        return study_bar(device_, passes_, views, {preset_for("fast", scene)}, 1);
    }
};

TEST_F(BarTest, FastErrsLessThanASingleFrameOfNineSlices) {
    for (const char* name : {"columns", "grass", "knot"}) {
        const Bar bar = bar_of(name, {.extent = {64, 36}, .frames = 16, .scored = 8, .rays = 64});
        EXPECT_LT(bar.temporal.shown, bar.exact.shown) << name;
        EXPECT_EQ(bar.temporal.raw, bar.temporal.shown) << name << ": its filter has ended";
        EXPECT_EQ(bar.readings.size(), 8U);
        EXPECT_EQ(bar.exact_ms.size(), 8U);
    }
}

// The single frames do not touch the run's history: it is that of the run alone.
TEST_F(BarTest, SingleFramesLeaveTheRunAsItIs) {
    const BenchmarkFrames frames{.extent = {48, 27}, .frames = 4, .scored = 2, .rays = 32};
    const scene::Scene scene = scene::make_scene("moving");
    BenchmarkViews views(device_, passes_, scene, frames, scene::TruthCache(""));
    const Settings fast = preset_for("fast", scene);
    AmbientOcclusion effect(device_, passes_, frames.extent);
    double error = 0.0;
    for (int i = 0; i < frames.frames; ++i) {
        i == 0 ? effect.begin(views.view(i, fast), fast) : effect.advance(views.view(i, fast));
        const Frame frame = effect.next();
        if (i >= 2) error += errors_of(frame.filtered, views.scored(i).geometry).rmse / 2.0;
    }
    const SliceTaps taps{.slices = 1, .steps = 2};
    const Bar bar = study_bar(device_, passes_, views, {fast, taps, taps}, 2);
    EXPECT_DOUBLE_EQ(bar.temporal.shown, error);
    EXPECT_EQ(bar.exact.shown, bar.fast.shown);
    EXPECT_EQ(bar.readings.size(), 4U);
    EXPECT_THROW((void)study_bar(device_, passes_, views, {fast, taps, taps}, 0), std::invalid_argument);
}

}  // namespace bar_test
}  // namespace gloam::effect
