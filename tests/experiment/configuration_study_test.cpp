// SPDX-License-Identifier: MIT
#include "experiment/configuration_study.hpp"
#include "effect/methods.hpp"
#include "effect/on_device.hpp"
#include "experiment/database.hpp"
#include "support/devices.hpp"

namespace gloam::experiment {

using effect::Settings;

namespace configuration_study_test {

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
        return {scene::make_scene(scene), frames};
    }
};

Settings four_samples() {
    Settings settings = effect::with_method({}, "hemisphere");
    settings.samples = settings.samples_converged = 4;
    return settings;
}

// All configurations of a size share one effect: each must find it as if it were new.
TEST_F(ConfigurationStudyTest, WhatWentBeforeLeavesNoTrace) {
    BenchmarkViews views = views_of("sky");
    const auto radius = static_cast<float>(views.scene().ao_radius);
    const Settings plain = with_radius(four_samples(), radius);
    Settings mapped = plain;
    mapped.table_size = 2'048;
    mapped.remap_c = 2.0F;
    const Settings others[] = {
        mapped, with_radius(effect::preset_named("study-volumetric-performance").settings, radius)};
    ConfigurationStudy fresh(device_, passes_);
    const FrameQuality expected = *fresh.visit(views, plain, true, 0).quality;
    ConfigurationStudy shared(device_, passes_);
    for (const Settings& other : others) {
        (void)shared.visit(views, other, true, 0);
        expect_same(*shared.visit(views, plain, true, 0).quality, expected);
        (void)shared.visit(views, other, false, 0);
        expect_same(*shared.visit(views, plain, true, 0).quality, expected);
    }
}

// The sky has no pixels over which samples are averaged.
TEST_F(ConfigurationStudyTest, SamplesAreCountedOverPixelsWithGeometry) {
    BenchmarkViews views = views_of("sky");
    Settings settings = with_radius(four_samples(), static_cast<float>(views.scene().ao_radius));
    settings.least_radius = 0.0F;
    ConfigurationStudy study(device_, passes_);
    for (const bool temporal : {false, true}) {
        EXPECT_DOUBLE_EQ(study.visit(views, settings, temporal, 0).quality->samples, 4.0) << temporal;
    }
}

// Blades of grass want more pixels.
TEST_F(ConfigurationStudyTest, FastAndBalancedErrLessThanASingleFrameOfNineSlices) {
    for (const char* name : {"columns", "room"}) {
        const BenchmarkFrames shown{.extent = {192, 108}, .frames = 16, .scored = 8, .every = 4, .rays = 64};
        BenchmarkViews views(scene::make_scene(name), shown);
        const auto settings_of = [&](const char* preset) {
            return with_radius(effect::preset_named(preset).settings,
                               static_cast<float>(views.scene().ao_radius));
        };
        const Settings balanced = settings_of("balanced");
        ConfigurationStudy study(device_, passes_);
        PlainRun loop(device_, passes_, shown.extent, {.slices = 9, .steps = 3}, 1);
        const double nine_slices = loop.visit(views, 0).quality->geometry;
        EXPECT_LT(study.visit(views, settings_of("fast"), true, 0).quality->geometry, nine_slices) << name;
        const FrameQuality run = *study.visit(views, balanced, true, 0).quality;
        EXPECT_LT(run.geometry, nine_slices) << name;
        EXPECT_EQ(study.visit(views, balanced, true, 1).readings.size(), 2U);
        EXPECT_EQ(loop.visit(views, 1).readings.size(), 2U);
    }
}

// A view that is shown for several frames is advanced once; without a truth nothing is judged.
TEST_F(ConfigurationStudyTest, ViewsAreShownForAsManyFramesAsAsked) {
    const BenchmarkFrames shown{.extent = {64, 36}, .frames = 4, .scored = 1, .rays = 0, .shown = {1, 3}};
    BenchmarkViews views(scene::make_scene("columns"), shown);
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
    ConfigurationStudy study(device_, passes_);
    const ConfigurationVisit visit = study.visit(views, settings, true, 0);
    EXPECT_FALSE(visit.quality);
    EXPECT_EQ(visit.shown.filtered, effect.next().filtered);
}

}  // namespace configuration_study_test

// What the temporal effect must be worth, on small images: the same numbers that `gloam bench temporal`
// measures.

namespace temporal_quality_test {

constexpr gpu::Extent small{96, 54};
// A quantity of one run, of a class of pixels in all scored frames.
double value_of(const ConfigurationVisit& visit, const std::string& quantity, const std::string& pixels) {
    Record record({});
    record.add({.size = small, .shown = {.name = "run"}, .candidate = "run", .quality = visit.quality});
    const Value value = Database(record)
                            .select("SELECT " + quantity + " FROM class_errors WHERE pixels = '" + pixels +
                                    "' AND against = 'geometry'")
                            .all.at(0)
                            .at(0);
    return std::get<double>(value);
}

Settings settings_for(const char* preset, const scene::Scene& scene) {
    return with_radius(effect::preset_named(preset).settings, static_cast<float>(scene.ao_radius));
}

// A mean over 128 samples instead of 500, always as many a frame, always rotated.
Settings short_memory(const scene::Scene& scene) {
    Settings settings = settings_for("tssao-paper", scene);
    settings.samples_converged = settings.samples;
    settings.weight_max = 128.0F;
    settings.c_rot = 2.0F;
    settings.c_adaptive = 0.78F;
    settings.filter_cap = 1.0F;
    return settings;
}

class TemporalQuality : public effect::OnDevice<testing::Test> {
  protected:
    // Scored by class.
    [[nodiscard]] static BenchmarkViews views_of(const char* name, BenchmarkFrames frames) {
        frames.depth_truth = false;
        frames.by_class = true;
        return {scene::make_scene(name), frames};
    }
};

TEST_F(TemporalQuality, MovingObjectsLeaveNoTrailAndWhatHasSettledStays) {
    BenchmarkViews views =
        views_of("moving", {.extent = small, .frames = 37, .scored = 25, .every = 12, .rays = 64});
    const Settings settings = settings_for("tssao-paper", views.scene());
    Settings without_nine = settings;
    without_nine.invalidation = effect::Invalidation::none;
    ConfigurationStudy study(device_, passes_);
    const ConfigurationVisit paper = study.visit(views, settings, true, 0);
    const ConfigurationVisit moving = study.visit(views, short_memory(views.scene()), true, 0);
    const ConfigurationVisit without = study.visit(views, without_nine, true, 0);
    const ConfigurationVisit single = study.visit(views, settings, false, 0);
    const auto near = [](const ConfigurationVisit& visit) {
        return value_of(visit, "rmse_raw", "near_moving");
    };
    EXPECT_LT(near(moving), 1.2 * near(single));
    EXPECT_LT(near(paper), 1.2 * near(single));
    EXPECT_GT(near(without), 1.2 * near(single)) << "without (9) there is a trail";
    const auto settled = [](const ConfigurationVisit& visit) { return value_of(visit, "rmse", "settled"); };
    EXPECT_LT(settled(moving), settled(single));
}

TEST_F(TemporalQuality, WhatComesIntoViewIsNoWorseThanASingleFrame) {
    BenchmarkViews views =
        views_of("columns", {.extent = small, .frames = 7, .scored = 4, .every = 3, .rays = 32});
    const Settings settings = settings_for("tssao-paper", views.scene());
    ConfigurationStudy study(device_, passes_);
    const auto disoccluded = [](const ConfigurationVisit& visit) {
        return value_of(visit, "rmse", "disoccluded");
    };
    const double single = disoccluded(study.visit(views, settings, false, 0));
    const double moving = disoccluded(study.visit(views, short_memory(views.scene()), true, 0));
    EXPECT_LT(moving, 1.05 * single) << "the same but for neighbours that have a history";
}

// The filtered image after some frames of the moving scene.
std::vector<float> after_frames(const gpu::Device& device, const scene::PassLibrary& passes,
                                const std::vector<scene::GBuffer>& sequence, const Settings& settings) {
    effect::AmbientOcclusion effect(device, passes, sequence.front().extent);
    effect::Frame frame;
    for (std::size_t i = 0; i < sequence.size(); ++i) {
        i == 0 ? effect.begin(sequence[i], settings) : effect.advance(sequence[i]);
        frame = effect.next();
    }
    return frame.filtered;
}

TEST_F(TemporalQuality, EveryDriverGivesTheSameOcclusion) {
    const scene::Scene scene = scene::make_scene("moving");
    std::vector<scene::GBuffer> sequence;
    for (int i = 0; i < 6; ++i)
        sequence.push_back(scene::draw(scene, {64, 36}, {.frame = i, .motion = true}));
    const Settings settings = settings_for("tssao-paper", scene);
    const std::vector<float> expected = after_frames(device_, passes_, sequence, settings);
    std::size_t others = 0;
    for (const gpu::DeviceInfo& info : test::devices_at_hand()) {
        if (info.name == device_.info().name) continue;
        gpu::Device other({.device = info.name, .validation = gpu::Validation::on});
        const effect::Errors difference =
            effect::errors_of(after_frames(other, passes_, sequence, settings), expected);
        // Points within rounding of a pixel's border or of the blocking depth may fall to either side: a few
        // of the 192 samples, at a few pixels.
        EXPECT_LT(difference.mean, 1e-4) << info.name;
        EXPECT_LT(difference.max, 0.05) << info.name;
        EXPECT_THAT(other.take_validation_messages(), IsEmpty()) << info.name;
        ++others;
    }
    if (others == 0) GTEST_SKIP() << "no second driver here (Debian's package chromium has SwiftShader)";
}

}  // namespace temporal_quality_test

}  // namespace gloam::experiment
