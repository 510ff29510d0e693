// SPDX-License-Identifier: MIT
// What the temporal effect must be worth, on small images: the same numbers that `gloam bench temporal`
// measures.
#include <string>
#include <vector>

#include "effect/methods.hpp"
#include "effect/on_device.hpp"
#include "experiment/configuration_study.hpp"
#include "experiment/table.hpp"
#include "support/devices.hpp"
#include "support/matchers.hpp"

namespace gloam::experiment {
namespace temporal_quality_test {

using effect::Settings;

constexpr gpu::Extent small{96, 54};
const Part to_limit{.against = "limit"};

// A quantity of one run.
double value_of(const ConfigurationVisit& visit, const char* quantity, const Part& part,
                const char* statistic = "median") {
    const CaseResult shown{.shown = {}, .cells = {Cell{.quality = visit.quality}}};
    return mean_value({&shown}, 0, quantity, statistic, part).value();
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
    // Scored by class, also against the limit of the preset `tssao-paper`.
    [[nodiscard]] BenchmarkViews views_of(const char* name, BenchmarkFrames frames) const {
        const scene::Scene scene = scene::make_scene(name);
        frames.depth_truth = false;
        frames.by_class = true;
        frames.limit = settings_for("tssao-paper", scene);
        return {device_, passes_, scene, frames, scene::TruthCache("")};
    }

    // So many frames of the first view.
    [[nodiscard]] ConfigurationVisit still(const char* name, gpu::Extent extent, int frames) const {
        BenchmarkViews views = views_of(name, {.extent = extent,
                                               .frames = frames,
                                               .scored = frames,
                                               .rays = 32,
                                               .still = true,
                                               .shown = {frames}});
        ConfigurationStudy study(device_, passes_, extent);
        return study.visit(views, settings_for("tssao-paper", views.scene()), true, 0);
    }
};

TEST_F(TemporalQuality, AStillViewConvergesFasterThanMonteCarlo) {
    for (const char* name : {"moving", "columns"}) {
        const ConfigurationVisit visit = still(name, small, 32);
        EXPECT_LT(value_of(visit, "rmse_raw", to_limit, "slope"), -1.0) << name;
        const Part last{.against = "limit", .frame = 32};
        EXPECT_LT(value_of(visit, "rmse_raw", last), 0.01) << name;
        EXPECT_LT(value_of(visit, "rmse", last), 0.01) << name;
    }
}

TEST_F(TemporalQuality, AThousandFramesDoNotDrift) {
    const ConfigurationVisit visit = still("moving", {48, 27}, 1000);
    const Part last{.against = "limit", .frame = 1000};
    const Part early{.against = "limit", .frame = 32};
    EXPECT_LT(value_of(visit, "rmse_raw", last), 1.1 * value_of(visit, "rmse_raw", early));
    EXPECT_LT(std::abs(value_of(visit, "bias_raw", last)), 1e-3);
}

TEST_F(TemporalQuality, MovingObjectsLeaveNoTrailAndWhatHasSettledStays) {
    BenchmarkViews views =
        views_of("moving", {.extent = small, .frames = 37, .scored = 25, .every = 12, .rays = 64});
    const Settings settings = settings_for("tssao-paper", views.scene());
    Settings without_nine = settings;
    without_nine.invalidation = effect::Invalidation::none;
    ConfigurationStudy study(device_, passes_, small);
    const ConfigurationVisit paper = study.visit(views, settings, true, 0);
    const ConfigurationVisit moving = study.visit(views, short_memory(views.scene()), true, 0);
    const ConfigurationVisit without = study.visit(views, without_nine, true, 0);
    const ConfigurationVisit single = study.visit(views, settings, false, 0);
    const ConfigurationVisit same_view = study.held(views, settings);
    const auto near = [](const ConfigurationVisit& visit, const char* against) {
        return value_of(visit, "rmse_raw", {.pixels = "near_moving", .against = against});
    };
    EXPECT_LT(near(moving, "limit"), 1.2 * near(single, "limit"));
    EXPECT_LT(near(moving, "geometry"), 1.2 * near(single, "geometry"));
    EXPECT_LT(near(paper, "geometry"), 1.2 * near(single, "geometry"));
    EXPECT_GT(near(without, "limit"), 1.5 * near(paper, "limit")) << "without (9) there is a trail";
    EXPECT_GT(near(without, "geometry"), 1.2 * near(single, "geometry"));
    const Part settled{.pixels = "settled", .against = "geometry"};
    EXPECT_LT(value_of(moving, "rmse", settled), 1.3 * value_of(same_view, "rmse", settled));
}

TEST_F(TemporalQuality, WhatComesIntoViewIsNoWorseThanASingleFrame) {
    BenchmarkViews views =
        views_of("columns", {.extent = small, .frames = 7, .scored = 4, .every = 3, .rays = 32});
    const Settings settings = settings_for("tssao-paper", views.scene());
    ConfigurationStudy study(device_, passes_, small);
    const auto disoccluded = [](const ConfigurationVisit& visit) {
        return value_of(visit, "rmse", {.pixels = "disoccluded", .against = "limit"});
    };
    const double single = disoccluded(study.visit(views, settings, false, 0));
    // Table 1's filter leaves them to neighbours that have converged; the cap does not.
    const double paper = disoccluded(study.visit(views, settings, true, 0));
    const double moving = disoccluded(study.visit(views, short_memory(views.scene()), true, 0));
    EXPECT_LT(moving, paper);
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
        sequence.push_back(scene::rasterize(device_, passes_, scene, {64, 36}, {.frame = i, .motion = true}));
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
        EXPECT_THAT(other.take_validation_messages(), testing::IsEmpty()) << info.name;
        ++others;
    }
    if (others == 0) GTEST_SKIP() << "no second driver here (Debian's package chromium has SwiftShader)";
}

}  // namespace temporal_quality_test
}  // namespace gloam::experiment
