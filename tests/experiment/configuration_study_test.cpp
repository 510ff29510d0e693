// SPDX-License-Identifier: MIT
#include "experiment/configuration_study.hpp"
#include "effect/methods.hpp"
#include "effect/on_device.hpp"

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

// The sky has no pixels over which samples are averaged, and each other pixel has one class.
TEST_F(ConfigurationStudyTest, SamplesAreCountedOverPixelsWithGeometry) {
    BenchmarkViews views(
        scene::make_scene("sky"),
        {.extent = {64, 36}, .frames = 4, .scored = 2, .rays = 32, .measures = {Quantity::by_class}});
    const Settings settings = settings_for(views, "samples=4 samples_converged=4 least_radius=0");
    for (const bool temporal : {false, true}) {
        const FrameQuality quality = study_.visit(views, settings, temporal, 0).quality.value();
        EXPECT_DOUBLE_EQ(quality.samples, 4.0) << temporal;
        double squares = 0.0;  // of all pixels, less those of each class
        for (const FrameScore& frame : quality.by_class->frames)
            for (const ClassScore& score : frame.classes)
                squares += score.pixels == "all" ? score.squares : -score.squares;
        EXPECT_NEAR(squares, 0.0, 1e-9) << temporal;
    }
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

}  // namespace gloam::experiment::configuration_study_test
