// SPDX-License-Identifier: MIT
#include "experiment/configuration_study.hpp"

#include <gtest/gtest.h>

#include "effect/methods.hpp"
#include "effect/on_device.hpp"

namespace gloam::experiment {
namespace configuration_study_test {

using effect::Settings;

const BenchmarkFrames frames{.extent = {64, 36}, .frames = 4, .scored = 2, .rays = 32};

// What a configuration is judged to be, without the times.
void expect_same(const FrameQuality& one, const FrameQuality& other) {
    EXPECT_EQ(one.raw_geometry, other.raw_geometry);
    EXPECT_EQ(one.geometry, other.geometry);
    EXPECT_EQ(one.depth, other.depth);
    EXPECT_EQ(one.similarity, other.similarity);
    EXPECT_EQ(one.flicker, other.flicker);
    EXPECT_EQ(one.samples, other.samples);
    EXPECT_EQ(one.memory_bytes, other.memory_bytes);
}

class ConfigurationStudyTest : public effect::OnDevice<testing::Test> {
  protected:
    [[nodiscard]] BenchmarkViews views_of(const char* scene) const {
        return {device_, passes_, scene::make_scene(scene), frames, scene::TruthCache("")};
    }
};

Settings four_samples() {
    Settings settings = with_method(effect::preset_named("balanced").settings, "hemisphere");
    settings.samples = settings.samples_converged = 4;
    return settings;
}

Settings all_skips(Settings settings) {
    settings.skip_open = true;
    settings.freeze = true;
    return settings;
}

// All configurations of a size share one effect: each must find it as if it were new.
TEST_F(ConfigurationStudyTest, WhatWentBeforeLeavesNoTrace) {
    BenchmarkViews views = views_of("sky");
    const auto radius = static_cast<float>(views.scene().ao_radius);
    const Settings plain = with_radius(four_samples(), radius);
    Settings half = all_skips(plain);
    half.precision = effect::HistoryPrecision::float16;
    half.table_size = 2'048;
    half.remap_c = 2.0F;
    const Settings others[] = {
        all_skips(plain), half,
        with_radius(effect::preset_named("study-volumetric-performance").settings, radius)};
    ConfigurationStudy fresh(device_, passes_, frames.extent);
    const FrameQuality expected = *fresh.visit(views, plain, true, 0).quality;
    ConfigurationStudy shared(device_, passes_, frames.extent);
    for (const Settings& other : others) {
        (void)shared.visit(views, other, true, 0);
        expect_same(*shared.visit(views, plain, true, 0).quality, expected);
        (void)shared.visit(views, other, false, 0);
        expect_same(*shared.visit(views, plain, true, 0).quality, expected);
    }
}

// A skipped tile is counted correctly: the sky has no pixels over which samples are averaged.
TEST_F(ConfigurationStudyTest, SamplesAreCountedOverPixelsWithGeometry) {
    BenchmarkViews views = views_of("sky");
    Settings settings = with_radius(four_samples(), static_cast<float>(views.scene().ao_radius));
    settings.least_radius = 0.0F;
    ConfigurationStudy study(device_, passes_, frames.extent);
    for (const bool temporal : {false, true}) {
        const FrameQuality with_skips = *study.visit(views, settings, temporal, 0).quality;
        EXPECT_DOUBLE_EQ(with_skips.samples, 4.0) << temporal;
        Settings without = settings;
        without.skip_background = false;
        without.skip_settled = false;
        EXPECT_DOUBLE_EQ(study.visit(views, without, temporal, 0).quality->samples, 4.0) << temporal;
    }
}

TEST_F(ConfigurationStudyTest, FastAndBalancedErrLessThanASingleFrameOfNineSlices) {
    for (const char* name : {"columns", "grass", "knot"}) {
        const BenchmarkFrames shown{.extent = {64, 36}, .frames = 16, .scored = 8, .rays = 64};
        BenchmarkViews views(device_, passes_, scene::make_scene(name), shown, scene::TruthCache(""));
        const auto settings_of = [&](const char* preset) {
            return with_radius(effect::preset_named(preset).settings,
                               static_cast<float>(views.scene().ao_radius));
        };
        const Settings balanced = settings_of("balanced");
        ConfigurationStudy study(device_, passes_, shown.extent);
        PlainRun loop(device_, passes_, shown.extent, {.slices = 9, .steps = 3}, 1);
        effect::CopyClock clock(device_, passes_, shown.extent);
        const double nine_slices = loop.visit(views, clock, 0).quality->geometry;
        EXPECT_LT(study.visit(views, settings_of("fast"), true, 0).quality->geometry, nine_slices) << name;
        const FrameQuality run = *study.visit(views, balanced, true, 0).quality;
        EXPECT_LT(run.geometry, nine_slices) << name;
        EXPECT_EQ(run.raw_geometry, run.geometry) << name << ": its filter has ended";
        EXPECT_EQ(study.visit(views, balanced, true, 1).readings.size(), 8U);
        EXPECT_EQ(loop.visit(views, clock, 1).readings.size(), 8U);
    }
}

// A view that is shown for several frames is advanced once; without a truth nothing is judged.
TEST_F(ConfigurationStudyTest, ViewsAreShownForAsManyFramesAsAsked) {
    const BenchmarkFrames shown{.extent = {64, 36}, .frames = 4, .scored = 1, .rays = 0, .shown = {1, 3}};
    BenchmarkViews views(device_, passes_, scene::make_scene("columns"), shown, scene::TruthCache(""));
    EXPECT_TRUE(views.is_new(0));
    EXPECT_TRUE(views.is_new(1));
    EXPECT_FALSE(views.is_new(2));
    EXPECT_EQ(&views.view(1, {}), &views.view(3, {}));
    const Settings settings = with_radius(four_samples(), static_cast<float>(views.scene().ao_radius));
    effect::AmbientOcclusion effect(device_, passes_, shown.extent);
    effect.begin(views.view(0, settings), settings);
    (void)effect.next();
    effect.advance(views.view(1, settings));
    for (int i = 0; i < 2; ++i) (void)effect.next();
    ConfigurationStudy study(device_, passes_, shown.extent);
    const ConfigurationVisit visit = study.visit(views, settings, true, 0);
    EXPECT_FALSE(visit.quality);
    EXPECT_EQ(visit.shown.filtered, effect.next().filtered);
}

}  // namespace configuration_study_test
}  // namespace gloam::experiment
