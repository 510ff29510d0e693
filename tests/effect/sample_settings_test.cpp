// SPDX-License-Identifier: MIT
// Settings that decide how many samples a pixel takes, from how far, which of them count, and how frames are
// averaged.
#include "effect/errors.hpp"
#include "on_device.hpp"
#include "surface_views.hpp"

namespace gloam::effect::sample_settings_test {

class SampleSettings : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] Frame frame_of(const Settings& settings, int frames = 1) const {
        return run(drawn(scene_, {96, 64}), settings, frames);
    }

    // Of the scene's radius, every sample taken and counted.
    [[nodiscard]] Settings plain(const char* method = "hemisphere") const {
        Settings settings = with_radius(with_method({}, method), static_cast<float>(scene_.ao_radius));
        settings.least_radius = 0.0F;
        return settings;
    }

    scene::Scene scene_ = scene::make_scene("columns");
};

// Samples in the mean of a pixel with a surface.
double per_pixel(const Frame& frame) {
    const auto surfaces = std::ranges::count_if(frame.convergence, [](float c) { return c > 0.0F; });
    return std::accumulate(frame.convergence.begin(), frame.convergence.end(), 0.0) /
           static_cast<double>(surfaces) * double{Settings{}.weight_max};
}

// What the mean counts was taken: whole slices, rays, pairs.
TEST_F(SampleSettings, WhatIsCountedWasTaken) {
    struct Asked {
        const char* method;
        std::uint32_t samples, steps;
        double taken;
    };
    for (const Asked& asked : {Asked{"hbao", 32, 6, 24},
                               {"hbao", 4, 6, 12},
                               {"dual_resolution", 32, 6, 24},
                               {"separable", 30, 4, 28},
                               {"unreal", 32, 3, 30},
                               {"angle", 7, 4, 8},
                               {"curvature", 30, 4, 28},
                               {"curvature", 1, 4, 4}}) {
        Settings settings = plain(asked.method);
        settings.samples = settings.samples_converged = asked.samples;
        settings.own.steps = asked.steps;
        settings.filter = Filter::none;
        EXPECT_NEAR(per_pixel(frame_of(settings)), asked.taken, 1e-4) << asked.method << ' ' << asked.samples;
    }
}

// A slice counts by its weight, so 16 frames of one slice are one frame of the same 16 slices. As a mean of
// quotients they differ by up to 0.12.
TEST_F(SampleSettings, SlicesOfManyFramesAreThoseOfOne) {
    for (const char* method : {"gtao", "sweep", "bitmask"}) {
        Settings settings = plain(method);
        settings.own.steps = 4;
        settings.filter = Filter::none;
        settings.weight_max = 1024.0F;
        settings.c_rot = 2.0F;
        settings.samples = settings.samples_converged = 8;
        const std::vector<float> frames = frame_of(settings, 16).occlusion;
        settings.samples = settings.samples_converged = 128;
        const std::vector<float> one = frame_of(settings).occlusion;
        ASSERT_EQ(frames.size(), one.size());
        EXPECT_LT(largest_difference(frames, one), 1e-5) << method;
    }
}

// Each frame by itself: the fifth is the first again, and has its samples alone.
TEST_F(SampleSettings, WithoutAHistoryEachFrameStandsByItself) {
    for (const char* method : {"hemisphere", "separable"}) {
        Settings settings = plain(method);
        settings.filter = Filter::none;
        settings.samples_converged = settings.samples;
        const std::vector<float> first = frame_of(settings).occlusion;
        EXPECT_NE(frame_of(settings, 5).occlusion, first) << method;
        settings.history = false;
        EXPECT_EQ(frame_of(settings).occlusion, first) << method;
        EXPECT_EQ(frame_of(settings, 5).occlusion, first) << method;
    }
}

// The slices of neighbouring pixels are spread evenly over all directions and jitters.
TEST_F(SampleSettings, OnALatticeAFilterLeavesLessNoise) {
    const scene::GBuffer view = groove({96, 64});
    const auto noise_after_filter = [&](Rotation rotation) {
        Settings settings = with_radius(with_method({}, "sweep"), 0.4F);
        settings.own.steps = 5;
        settings.samples = 10;
        settings.c_rot = 2.0F;
        settings.c_adaptive = 1.0F;
        settings.filter_sigma = 0.4F;
        settings.rotation = rotation;
        const std::vector<float> filtered = run(view, settings).filtered;
        settings.samples = settings.samples_converged = 1024;
        return errors_of(filtered, run(view, settings).occlusion).rmse;
    };
    EXPECT_LT(noise_after_filter(Rotation::lattice), 0.8 * noise_after_filter(Rotation::hash));
}

// In a disc of few pixels several taps share one, which counts as often as it is read in one of the methods.
TEST_F(SampleSettings, DistinctTapsOfOnePixelCountOnce) {
    const scene::GBuffer view = groove({96, 64});
    const auto occlusion = [&](const char* method) {
        return run(view, with_radius(with_method({}, method), 0.2F)).occlusion;
    };
    EXPECT_NE(occlusion("issao"), occlusion("issao_distinct"));
}

}  // namespace gloam::effect::sample_settings_test
