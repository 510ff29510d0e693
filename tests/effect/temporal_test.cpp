// SPDX-License-Identifier: MIT
// The history on moving cameras and objects: it survives what it should and dies when it must.
#include "effect/errors.hpp"
#include "effect/methods.hpp"
#include "on_device.hpp"
#include "surface_views.hpp"

namespace gloam::effect::temporal_test {

constexpr gpu::Extent extent{96, 64};

Settings paper() {
    return with_radius(preset_named("tssao-paper").settings, 0.5F);
}

class Temporal : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] scene::GBuffer view(const scene::Scene& scene, int frame, bool motion = true) const {
        return drawn(scene, extent, {.frame = frame, .motion = motion});
    }

    // The first frames of a scene.
    [[nodiscard]] std::vector<Frame> sequence(const scene::Scene& scene, const Settings& settings,
                                              int frames) const {
        std::vector<scene::GBuffer> views;
        for (int i = 0; i < frames; ++i) views.push_back(view(scene, i));
        return run(views, settings);
    }

    // Many samples of that view alone.
    [[nodiscard]] std::vector<float> converged(const scene::Scene& scene, int frame,
                                               const Settings& settings) const {
        Settings many = settings;
        many.samples = many.samples_converged = 1024;
        return run(view(scene, frame), many).occlusion;
    }
};

TEST_F(Temporal, ACameraThatStandsStillLosesAndBlursNothing) {
    const scene::Scene scene = floor_and_wall(false);
    const Settings settings = paper();
    const Frame expected = run(view(scene, 0), settings, 6);
    expect_same_images(sequence(scene, settings, 6).back(), expected,
                       {&Frame::occlusion, &Frame::convergence});
}

TEST_F(Temporal, HistoryFollowsAPanningCamera) {
    const scene::Scene scene = panned(floor_and_wall(false), 0.02);
    const Settings settings = paper();
    const Frame moving = sequence(scene, settings, 8).back();
    const Frame alone = run(view(scene, 7), settings);
    const std::vector<float> truth = converged(scene, 7, settings);
    const double with_history = errors_of(moving.occlusion, truth).rmse;
    const double without = errors_of(alone.occlusion, truth).rmse;
    EXPECT_LT(with_history, 0.6 * without) << with_history << " against " << without;
    EXPECT_GT(mean_of(moving.convergence), 0.8 * 8 * 32 / 500.0);
}

TEST_F(Temporal, DisoccludedPixelsHaveNoHistory) {
    const scene::Scene scene = floor_and_wall(true, 0.15);
    const std::vector<Frame> frames = sequence(scene, paper(), 4);
    for (int i = 1; i < 4; ++i) {
        const scene::GBuffer before = view(scene, i - 1);
        const scene::GBuffer now = drawn(scene, extent, {.frame = i, .motion = true, .ids = true});
        std::size_t uncovered = 0;
        for (std::size_t p = 0; p < now.depth.size(); ++p) {
            // The background came out from behind the box, which was nearer by far more than the tolerance.
            const bool freed = now.object[p] == 0 && before.depth[p] < 0.9F * now.depth[p];
            if (!freed) continue;
            ++uncovered;
            EXPECT_EQ(frames[static_cast<std::size_t>(i)].kept[p], 0.0F) << "pixel " << p;
        }
        EXPECT_GT(uncovered, 10U);
    }
}

TEST_F(Temporal, HistoryMovesWithAnObject) {
    const scene::Scene scene = floor_and_wall(true, 0.04);
    const Frame frame = sequence(scene, paper(), 5).back();
    const scene::GBuffer now = drawn(scene, extent, {.frame = 4, .motion = true, .ids = true});
    std::size_t on_box = 0;
    std::size_t kept = 0;
    for (std::size_t p = 0; p < now.depth.size(); ++p) {
        on_box += now.object[p] == 1;
        kept += now.object[p] == 1 && frame.kept[p] > 0.0F;
    }
    EXPECT_GT(on_box, 100U);
    EXPECT_GT(static_cast<double>(kept), 0.9 * static_cast<double>(on_box));
}

TEST_F(Temporal, ACutAndAnotherSizeForget) {
    const scene::Scene scene = panned(floor_and_wall(false), 0.01);
    AmbientOcclusion effect(device_, passes_, extent);
    effect.begin(view(scene, 0), paper());
    (void)effect.next();
    effect.advance(view(scene, 1));
    EXPECT_GT(mean_of(effect.next().kept), 1.0);
    effect.advance(view(scene, 0));  // frame 0 knows no frame before: a cut
    EXPECT_EQ(mean_of(effect.next().kept), 0.0);
    const gpu::Extent other{40, 30};
    effect.advance(drawn(scene, other, {.frame = 2, .motion = true}));
    const Frame resized = effect.next();
    EXPECT_EQ(resized.occlusion.size(), std::size_t{other.width} * other.height);
    EXPECT_EQ(mean_of(resized.kept), 0.0);
}

TEST_F(Temporal, AZoomKeepsTheHistoryWhereItWasInView) {
    scene::Scene scene = floor_and_wall(false);
    scene.camera_path = [start = scene.camera](int frame) {
        scene::Camera camera = start;
        camera.fovy_rad = 0.9 - 0.05 * frame;
        return camera;
    };
    const Frame frame = sequence(scene, paper(), 4).back();
    EXPECT_GT(mean_of(frame.convergence), 0.9 * 4 * 32 / 500.0) << "the projection of each frame is its own";
}

// A plane at depth 5 whose right half is somewhere else, and moves in depth from one frame to the next.
struct MovingHalf {
    scene::GBuffer before;
    scene::GBuffer after;

    static constexpr std::size_t left_of_the_edge = 96 * 32 + 47;

    MovingHalf(double depth_before, double depth_after)
        : before(view_with(depth_before)), after(view_with(depth_after)) {
        const glm::vec2 scale(after.camera.p00_p11());
        after.camera.previous_from_current = glm::mat4(1.0F);
        for (std::size_t i = 0; i < after.depth.size(); ++i) {
            const auto x = static_cast<float>(2 * (i % extent.width) + 1) / extent.width - 1.0F;
            const auto y = static_cast<float>(2 * (i / extent.width) + 1) / extent.height - 1.0F;
            after.previous_position.emplace_back(x / scale.x, y / scale.y, -before.depth[i]);
        }
    }

  private:
    static scene::GBuffer view_with(double depth) {
        scene::GBuffer view = view_of(extent, true, [&](glm::dvec2 at) { return at.x > 0.0 ? depth : 5.0; });
        return view;
    }
};

// A sample of the hemisphere is blocked by surfaces up to `range` in front of it, for any radius. When a
// surface leaves that range, the occlusion changes.
TEST_F(Temporal, ProbesReachAsFarAsWhatBlocks) {
    const MovingHalf plate(4.2, 3.0);
    Settings settings = with_radius(with_method(paper(), "hemisphere"), 0.2F);
    settings.own.range = 1.0F;
    settings.invalidation = Invalidation::clamp;
    settings.weight_small = 1.0F;
    AmbientOcclusion& effect = effect_for(extent);
    effect.begin(plate.before, settings);
    for (int i = 0; i < 7; ++i) (void)effect.next();
    const Frame blocked = effect.next();
    effect.advance(plate.after);
    const Frame open = effect.next();
    const std::size_t pixel = MovingHalf::left_of_the_edge;
    EXPECT_GT(blocked.occlusion[pixel], 0.1F);
    EXPECT_GT(open.kept[pixel], 0.0F);
    EXPECT_LT(open.occlusion[pixel], 0.1F * blocked.occlusion[pixel]);
    EXPECT_LT(open.convergence[pixel], 0.5F * blocked.convergence[pixel]);
    const std::size_t further = pixel - 40;  // from the plate than the radius
    EXPECT_GT(open.convergence[further], blocked.convergence[further]);
}

TEST_F(Temporal, WhatMovesTogetherKeepsItsHistory) {
    MovingHalf floor(5.0, 5.0);
    for (float& depth : floor.before.depth) depth += 0.2F;
    for (glm::vec3& position : floor.after.previous_position) position.z -= 0.2F;
    AmbientOcclusion& effect = effect_for(extent);
    effect.begin(floor.before, paper());
    const float once = effect.next().convergence.front();
    effect.advance(floor.after);
    EXPECT_THAT(effect.next().convergence, Each(testing::FloatNear(2.0F * once, 1e-6F)));
}

// The edge of a surface before the background keeps its history while something moves elsewhere.
TEST_F(Temporal, BackgroundUnderASampleIsNoChange) {
    MovingHalf still(std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
    still.after.previous_position.front().z -= 0.1F;
    for (const Invalidation invalidation : {Invalidation::confidence, Invalidation::clamp}) {
        Settings settings = paper();
        settings.invalidation = invalidation;
        AmbientOcclusion& effect = effect_for(extent);
        effect.begin(still.before, settings);
        for (int i = 0; i < 3; ++i) (void)effect.next();
        const float before = effect.next().convergence[MovingHalf::left_of_the_edge];
        effect.advance(still.after);
        EXPECT_GT(effect.next().convergence[MovingHalf::left_of_the_edge], before);
    }
}

// A pixel that takes no samples has no probes, so its history stays unchanged when objects move beside it.
TEST_F(Temporal, WithoutSamplesTheHistoryStays) {
    const MovingHalf pit(5.3, 6.0);
    Settings settings = with_radius(with_method(paper(), "hemisphere"), 0.5F);
    settings.samples_distance = 5.5F;  // none from there on
    settings.samples_least = 0;
    AmbientOcclusion& effect = effect_for(extent);
    for (const bool smooths : {false, true}) {
        settings.invalidation = smooths ? Invalidation::confidence : Invalidation::clamp;
        settings.smoothing = smooths ? 0.25F : 0.0F;
        effect.begin(pit.before, settings);
        const Frame near = effect.next();
        effect.advance(pit.after);
        const Frame far = effect.next();
        float darkest = 0.0F;
        for (std::size_t y = 8; y < extent.height - 8; ++y) {
            const std::size_t pixel = extent.width * y + extent.width / 2;
            EXPECT_GT(near.convergence[pixel], 0.0F);
            EXPECT_EQ(far.convergence[pixel], near.convergence[pixel]);
            EXPECT_EQ(far.occlusion[pixel], near.occlusion[pixel]);
            darkest = std::max(darkest, near.occlusion[pixel]);
        }
        EXPECT_GT(darkest, 0.1F);
    }
}

TEST_F(Temporal, OutOfOrderAndOutOfRangeAreErrors) {
    AmbientOcclusion effect(device_, passes_, extent);
    const scene::GBuffer first = view(floor_and_wall(false), 0);
    EXPECT_THROW(effect.advance(first), std::logic_error);
    effect.begin(first, paper());
    scene::GBuffer wrong = first;
    wrong.camera.previous_from_current = glm::mat4(1.0F);
    wrong.previous_position.resize(7);
    expect_error<std::invalid_argument>([&] { effect.advance(wrong); }, {"previous positions: 7 pixels"});
}

}  // namespace gloam::effect::temporal_test
