// SPDX-License-Identifier: MIT
// The guard band: surfaces near the frame's edge have their neighbours and their history, and the rest does
// not change.
#include "effect/errors.hpp"
#include "effect/methods.hpp"
#include "on_device.hpp"
#include "scene/truth.hpp"

namespace gloam::effect::border_test {

constexpr gpu::Extent extent{96, 54};

Settings settings_for(const scene::Scene& scene, float guard) {
    Settings settings =
        with_radius(preset_named("tssao-paper").settings, static_cast<float>(scene.ao_radius));
    settings.guard = guard;
    return settings;
}

// Pixels from the nearest edge of the frame, 0 at the edge.
std::uint32_t from_edge(std::size_t pixel, gpu::Extent size = extent) {
    const auto x = static_cast<std::uint32_t>(pixel % size.width);
    const auto y = static_cast<std::uint32_t>(pixel / size.width);
    return std::min({x, y, size.width - 1 - x, size.height - 1 - y});
}

class Guard : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] scene::GBuffer view(const scene::Scene& scene, float guard, int frame = 0) const {
        return drawn(scene, extent, {.frame = frame, .motion = true, .guard = double{guard}});
    }

    // The last of `frames` frames of a moving one.
    [[nodiscard]] Frame moving(const scene::Scene& scene, const Settings& settings, int frames) const {
        std::vector<scene::GBuffer> views;
        for (int i = 0; i < frames; ++i) views.push_back(view(scene, settings.guard, i));
        return run(views, settings).back();
    }
};

// Further from the edge than any sample reaches and the filter after it. A sample that falls within rounding
// of a pixel's border or of the surface may fall to the other side, for the projection is another: a few
// pixels change by a sample.
TEST_F(Guard, PixelsFurtherThanTheRadiusFromTheEdgeStayAsTheyAre) {
    const scene::Scene scene = scene::make_scene("columns");
    const scene::GBuffer wide = view(scene, 0.1F);
    const scene::GBuffer plain = scene::cropped(wide);
    constexpr float radius = 0.25F;
    const Settings settings = with_radius(settings_for(scene, 0.0F), radius);
    const Frame with = run(wide, settings, 4);
    const Frame without = run(plain, settings, 4);
    const scene::PixelPositions positions(plain);
    std::size_t inner = 0;
    std::size_t changed = 0;
    for (std::size_t i = 0; i < plain.depth.size(); ++i) {
        if (!(plain.depth[i] > 1.5F * radius) || std::isinf(plain.depth[i])) continue;
        const double reach = positions.pixels_of_length(radius, plain.depth[i] - radius) + 4.0;
        if (from_edge(i) < reach) continue;
        ++inner;
        changed += with.occlusion[i] != without.occlusion[i] ? 1 : 0;
        EXPECT_NEAR(with.occlusion[i], without.occlusion[i], 2.01 / 128.0) << i;
    }
    EXPECT_GT(inner, 500U);
    EXPECT_LT(static_cast<double>(changed), 0.02 * static_cast<double>(inner));
}

// Against the geometry, ray-traced.
TEST_F(Guard, TheEdgeComesCloserToTheTruth) {
    const scene::Scene scene = scene::make_scene("room");
    const auto error = [&](float guard) {
        const scene::GBuffer wide = view(scene, guard);
        const scene::TracedTruth truth = trace_geometry(scene, 0, scene::cropped(wide),
                                                        {.rays = {.radius = scene.ao_radius, .rays = 128}});
        std::vector<float> edge = truth.occlusion;
        for (std::size_t i = 0; i < edge.size(); ++i)
            if (from_edge(i) >= 4) edge[i] = nan;
        return errors_of(run(wide, settings_for(scene, guard), 8).occlusion, edge).rmse;
    };
    const double without = error(0.0F);
    const double with = error(0.1F);
    EXPECT_LT(with, 0.75 * without);
}

TEST_F(Guard, WhatMovesInFromTheBandHasAHistory) {
    scene::Scene scene = scene::make_scene("room");
    scene.camera_path = [start = scene.camera](int frame) {  // turns by about a pixel in each frame
        scene::Camera camera = start;
        const glm::dvec3 ahead = glm::normalize(start.target - start.eye);
        camera.target = start.eye + ahead + 0.012 * frame * glm::normalize(glm::cross(ahead, start.up));
        return camera;
    };
    const auto without_history = [&](float guard, bool sampled) {
        Settings settings = settings_for(scene, guard);
        settings.guard_history = sampled;
        const Frame frame = moving(scene, settings, 6);
        std::size_t count = 0;
        for (std::size_t i = 0; i < frame.kept.size(); ++i)
            count += i % extent.width >= extent.width - 2 && frame.kept[i] == 0.0F ? 1 : 0;
        return count;
    };
    const auto plain = without_history(0.0F, true);
    const auto sampled = without_history(0.1F, true);
    const auto left_out = without_history(0.1F, false);
    EXPECT_GT(plain, 50U);
    EXPECT_LT(sampled, plain / 10);
    EXPECT_GT(left_out, plain * 9 / 10);
}

// Bad numbers in one frame of a sequence: nothing but numbers from 0 to 1 is shown, the history of the pixels
// dies, and a few frames later nothing is left of them.

constexpr gpu::Extent small{64, 36};
constexpr int poisoned_frame = 3;

// A block of pixels amid the view.
bool in_block(std::size_t pixel) {
    const std::size_t x = pixel % small.width;
    const std::size_t y = pixel / small.width;
    return x >= 24 && x < 34 && y >= 12 && y < 22;
}

using Change = std::function<void(scene::GBuffer&)>;

class Poison : public OnDevice<testing::Test> {
  protected:
    Poison() {
        for (int i = 0; i < 8; ++i) views_.push_back(drawn(scene_, small, {.frame = 20 + i, .motion = true}));
    }

    // All frames, one of them changed.
    [[nodiscard]] std::vector<Frame> run(const Change& change) const {
        const Settings settings = with_radius(Settings{}, static_cast<float>(scene_.ao_radius));
        std::vector<scene::GBuffer> views = views_;
        change(views[poisoned_frame]);
        return OnDevice::run(views, settings);
    }

    void expect_sane(const std::vector<Frame>& frames, const std::vector<Frame>& clean,
                     const std::string& what) const {
        for (const Frame& frame : frames) {
            for (const auto* image : {&frame.occlusion, &frame.filtered, &frame.convergence})
                EXPECT_THAT(*image, Each(AllOf(testing::Ge(0.0F), testing::Le(1.0F)))) << what;
            EXPECT_THAT(frame.kept, Each(testing::Truly([](float v) { return v >= 0 && v < infinity; })));
        }
        // Later the clean frames have outvoted it.
        double difference = 0.0;
        for (std::size_t i = 0; i < clean.back().occlusion.size(); ++i)
            difference += std::abs(double{frames.back().occlusion[i]} - double{clean.back().occlusion[i]});
        EXPECT_LT(difference / static_cast<double>(clean.back().occlusion.size()), 0.01) << what;
    }

    scene::Scene scene_ = scene::make_scene("moving");
    std::vector<scene::GBuffer> views_;
};

// What is put into the block.
struct Bad {
    const char* what;
    void (*put)(scene::GBuffer& view, std::size_t pixel, float value);
};
constexpr Bad bad_inputs[] = {
    {"depth", [](scene::GBuffer& view, std::size_t pixel, float value) { view.depth[pixel] = value; }},
    {"position", [](scene::GBuffer& view, std::size_t pixel,
                    float value) { view.previous_position[pixel] = glm::vec3(value); }},
    {"normal", [](scene::GBuffer& view, std::size_t pixel, float value) { view.normal[pixel].y = value; }}};

TEST_F(Poison, InputsOfOneFrame) {
    const std::vector<Frame> clean = run([](scene::GBuffer&) {});
    for (const Bad& bad : bad_inputs) {
        for (const float value : {nan, -infinity, 3e38F}) {
            const std::vector<Frame> frames = run([&](scene::GBuffer& view) {
                for (std::size_t i = 0; i < view.depth.size(); ++i)
                    if (in_block(i)) bad.put(view, i, value);
            });
            const std::string what = bad.what + (" " + std::to_string(value));
            expect_sane(frames, clean, what);
            std::size_t kept = 0;
            std::size_t kept_later = 0;
            for (std::size_t i = 0; i < small.width * small.height; ++i) {
                kept += in_block(i) && frames[poisoned_frame].kept[i] > 0.0F ? 1 : 0;
                kept_later += in_block(i) && frames[poisoned_frame + 1].kept[i] > 0.0F ? 1 : 0;
            }
            EXPECT_TRUE(kept == 0 || bad.what != std::string("position")) << what;
            EXPECT_TRUE(kept_later < 40 || bad.what != std::string("depth"))
                << what << ", of 100 that were another surface; the rim is the neighbours'";
        }
    }
}

TEST_F(Poison, MatricesOfOneFrame) {
    const std::vector<Frame> clean = run([](scene::GBuffer&) {});
    for (const float bad : {nan, infinity, 0.0F}) {
        const std::vector<Frame> frames = run([bad](scene::GBuffer& view) {
            view.previous_position.clear();
            view.camera.previous_from_current = glm::mat4(bad);
        });
        expect_sane(frames, clean, "matrix " + std::to_string(bad));
        EXPECT_THAT(frames[poisoned_frame].kept, Each(0.0F)) << bad;
    }
}

// From one kind of projection to the other the surfaces stay what they are.
TEST_F(Poison, AnotherKindOfProjectionIsNone) {
    scene_.camera_path = [start = scene_.camera](int frame) {
        scene::Camera camera = start;
        camera.projection = frame % 2 == 0 ? scene::Projection::perspective : scene::Projection::orthographic;
        camera.view_height = 2.0 * std::tan(0.5 * start.fovy_rad) * 4.0;
        return camera;
    };
    scene_.objects.clear();
    std::vector<scene::GBuffer> views;
    for (int i = 0; i < 4; ++i) views.push_back(drawn(scene_, small, {.frame = i}));
    const std::vector<Frame> frames = OnDevice::run(views, with_radius(Settings{}, 0.4F));
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const auto kept = std::ranges::count_if(frames[i].kept, [](float v) { return v > 0.0F; });
        EXPECT_EQ(kept > small.width * small.height / 3, i > 0) << "frame " << i << ": " << kept;
        EXPECT_THAT(frames[i].occlusion, Each(AllOf(testing::Ge(0.0F), testing::Le(1.0F))));
    }
}

}  // namespace gloam::effect::border_test
