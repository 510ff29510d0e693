// SPDX-License-Identifier: MIT
#include "experiment/configuration_study.hpp"
#include "effect/methods.hpp"
#include "effect/on_device.hpp"
#include "experiment/database.hpp"

namespace gloam::experiment::configuration_study_test {

using effect::Settings;

class ConfigurationStudyTest : public effect::OnDevice<testing::Test> {
  protected:
    // Changes of the defaults, for a scene's radius.
    [[nodiscard]] static Settings settings_for(const BenchmarkViews& views, const std::string& changes) {
        return with_radius(effect::with(Settings{}, changes), static_cast<float>(views.scene().ao_radius));
    }

    ConfigurationStudy study_{device_, passes_};
};

// The sky has no pixels over which samples are averaged.
TEST_F(ConfigurationStudyTest, SamplesAreCountedOverPixelsWithGeometry) {
    BenchmarkViews views(scene::make_scene("sky"),
                         {.extent = {64, 36}, .frames = 4, .scored = 2, .rays = 32});
    const Settings settings = settings_for(views, "samples=4 samples_converged=4 least_radius=0");
    for (const bool temporal : {false, true})
        EXPECT_DOUBLE_EQ(study_.visit(views, settings, temporal, 0).quality->samples, 4.0) << temporal;
}

// Blades of grass want more pixels.
TEST_F(ConfigurationStudyTest, FastAndBalancedErrLessThanASingleFrameOfNineSlices) {
    for (const char* name : {"columns", "room"}) {
        const BenchmarkFrames shown{.extent = {192, 108}, .frames = 16, .scored = 8, .every = 4, .rays = 64};
        BenchmarkViews views(scene::make_scene(name), shown);
        const Settings balanced = settings_for(views, "preset=balanced");
        effect::PlainSlices loop(device_, passes_, shown.extent, {.slices = 9, .steps = 3});
        const double nine_slices = plain_visit(loop, views, 0).quality->geometry;
        EXPECT_LT(study_.visit(views, settings_for(views, "preset=fast"), true, 0).quality->geometry,
                  nine_slices)
            << name;
        const FrameQuality run = *study_.visit(views, balanced, true, 0).quality;
        EXPECT_LT(run.geometry, nine_slices) << name;
        EXPECT_EQ(study_.visit(views, balanced, true, 1).readings.size(), 2U);
        EXPECT_EQ(plain_visit(loop, views, 1).readings.size(), 2U);
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
    const Settings settings = settings_for(views, "samples=4 samples_converged=4");
    effect::AmbientOcclusion effect(device_, passes_);
    effect.begin(views.view(0, settings), settings);
    (void)effect.next();
    effect.advance(views.view(1, settings));
    for (int i = 0; i < 2; ++i) (void)effect.next();
    const ConfigurationVisit visit = study_.visit(views, settings, true, 0);
    EXPECT_FALSE(visit.quality);
    EXPECT_EQ(visit.shown.filtered, effect.next().filtered);
}

// What the temporal effect must be worth, on small images: the same numbers that `gloam bench temporal`
// measures.

// A quantity of one run, of a class of pixels in all scored frames.
double value_of(const ConfigurationVisit& visit, const std::string& quantity, const std::string& pixels) {
    Record record({});
    record.add({.shown = {.name = "run"}, .candidate = "run", .quality = visit.quality});
    return std::stod(Database(record)
                         .texts("SELECT " + quantity + " FROM class_errors WHERE pixels = '" + pixels +
                                "' AND against = 'geometry'")
                         .at(0));
}

// The second is a mean over 128 samples instead of 500, always as many a frame, always rotated.
TEST_F(ConfigurationStudyTest, MovingObjectsLeaveNoTrailAndWhatHasSettledStays) {
    BenchmarkViews views(scene::make_scene("moving"), {.extent = {96, 54},
                                                       .frames = 37,
                                                       .scored = 25,
                                                       .every = 12,
                                                       .rays = 64,
                                                       .depth_truth = false,
                                                       .measures = {Quantity::by_class}});
    const auto visit = [&](const char* changes, bool temporal) {
        return study_.visit(views, settings_for(views, changes), temporal, 0);
    };
    const ConfigurationVisit paper = visit("", true);
    const ConfigurationVisit moving =
        visit("samples_converged=32 weight_max=128 c_rot=2 c_adaptive=0.78 filter_cap=1", true);
    const ConfigurationVisit without = visit("invalidation=none", true);
    const ConfigurationVisit single = visit("", false);
    const auto near = [](const ConfigurationVisit& visit) {
        return value_of(visit, "rmse_raw", "near_moving");
    };
    EXPECT_LT(near(moving), 1.2 * near(single));
    EXPECT_LT(near(paper), 1.2 * near(single));
    EXPECT_GT(near(without), 1.2 * near(single)) << "without (9) there is a trail";
    const auto settled = [](const ConfigurationVisit& visit) { return value_of(visit, "rmse", "settled"); };
    EXPECT_LT(settled(moving), settled(single));
}

}  // namespace gloam::experiment::configuration_study_test
