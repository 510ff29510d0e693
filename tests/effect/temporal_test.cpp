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
