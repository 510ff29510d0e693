// SPDX-License-Identifier: MIT
// The study's frames: what a history survives, and what is refused.
#include "effect/errors.hpp"
#include "effect/methods.hpp"
#include "on_device.hpp"
#include "support/poison.hpp"
#include "surface_views.hpp"

namespace gloam::effect::study_frames_test {

constexpr backend::Extent small{64, 36};

class Poison : public OnDevice<testing::Test> {
  protected:
    static void expect_sane(const Frame& frame, const std::string& what) {
        for (const auto* image : {&frame.occlusion, &frame.filtered, &frame.convergence})
            EXPECT_THAT(*image, Each(AllOf(testing::Ge(0.0F), testing::Le(1.0F)))) << what;
        EXPECT_THAT(frame.kept, Each(testing::Truly([](float v) { return v >= 0 && v < infinity; }))) << what;
    }

    scene::Scene scene_ = scene::make_scene("moving");
};

// Nothing but numbers from 0 to 1 is shown, no history is found by what says nothing of it, and a few frames
// later the clean frames have outvoted the poison.
TEST_F(Poison, OfOneFrameDoesNotStay) {
    constexpr std::size_t frame = 3;
    constexpr std::size_t pixel = 7 * 9 * 18;  // one of those that are poisoned
    const std::vector<scene::GBuffer> views = sequence_of("moving", small, 8, {.frame = 20, .motion = true});
    const Settings settings = with_radius(Settings{}, static_cast<float>(scene_.ao_radius));
    const std::vector<Frame> clean = run(views, settings);
    EXPECT_GT(clean[frame].kept[pixel], 0.0F);
    const auto expect = [&](const std::string& what, void (*put)(scene::GBuffer&, float)) {
        for (const float value : {nan, -infinity, 3e38F}) {
            std::vector<scene::GBuffer> poisoned = views;
            put(poisoned[frame], value);
            const std::vector<Frame> frames = run(poisoned, settings);
            for (const Frame& one : frames) expect_sane(one, what);
            EXPECT_LT(errors_of(frames.back().filtered, clean.back().filtered).mean, 0.01) << what;
            EXPECT_EQ(frames[frame].kept[pixel], 0.0F) << what << value;
        }
    };
    expect("images", [](scene::GBuffer& view, float) { test::poison(view); });
    expect("position", [](scene::GBuffer& view, float value) {
        for (std::size_t i = 0; i < view.depth.size(); i += 9) view.previous_position[i] = glm::vec3(value);
    });
    expect("matrix", [](scene::GBuffer& view, float value) {
        view.previous_position.clear();
        view.camera.previous_from_current = glm::mat4(value);
    });
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
    const std::vector<Frame> frames = run(sequence_of(scene_, small, 4), with_radius(Settings{}, 0.4F));
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const auto kept = std::ranges::count_if(frames[i].kept, [](float v) { return v > 0.0F; });
        EXPECT_EQ(kept > small.width * small.height / 3, i > 0) << "frame " << i << ": " << kept;
        expect_sane(frames[i], "frame " + std::to_string(i));
    }
}

constexpr backend::Extent extent{96, 64};

const Settings paper = with_radius({}, 0.5F);

using Temporal = OnDevice<testing::Test>;

TEST_F(Temporal, ACutAndAnotherSizeForget) {
    AmbientOcclusion& effect = shared_effect();
    effect.begin(drawn("moving", extent), paper);
    (void)effect.next();
    const backend::Extent other{40, 30};
    effect.advance(drawn("moving", other, {.frame = 1, .motion = true}));
    const Frame resized = effect.next();
    EXPECT_EQ(mean_of(resized.kept), 0.0);
    effect.advance(drawn("moving", other, {.frame = 2, .motion = true}));
    EXPECT_GT(mean_of(effect.next().kept), 1.0);
    effect.advance(drawn("moving", other));  // which knows no frame before
    EXPECT_EQ(mean_of(effect.next().kept), 0.0);
}

TEST_F(Temporal, AZoomKeepsTheHistoryWhereItWasInView) {
    scene::Scene scene = floor_and_wall(false);
    scene.camera_path = [start = scene.camera](int frame) {
        scene::Camera camera = start;
        camera.fovy_rad = 0.9 - 0.05 * frame;
        return camera;
    };
    const std::vector<scene::GBuffer> views = sequence_of(scene, extent, 4, {.motion = true});
    EXPECT_GT(mean_of(run(views, paper).back().convergence), 0.9 * 4 * 32 / 500.0)
        << "the projection of each frame is its own";
}

TEST_F(Temporal, WhatCannotBeIsRefused) {
    const scene::GBuffer view = wall({8, 8}, 3.0F);
    using Change = std::function<void(scene::GBuffer&, Settings&)>;
    const std::vector<std::pair<Change, const char*>> rows{
        {[](scene::GBuffer&, Settings& settings) { settings.radius = nan; }, "radius"},
        {[](scene::GBuffer&, Settings& settings) { settings.guard = 0.1F; }, "no guard band"},
        {[](scene::GBuffer& changed, Settings&) { changed.off_centre = {4, 0}; }, "centred"},
        {[](scene::GBuffer& changed, Settings&) { changed.border = backend::Extent{4, 0}; }, "no frame"},
        {[](scene::GBuffer&, Settings& settings) { settings.own.layers = 2; }, "layers 2: the view has 1"}};
    for (const auto& [change, named] : rows) {
        scene::GBuffer changed = view;
        Settings settings = paper;
        change(changed, settings);
        expect_error<std::invalid_argument>([&] { shared_effect().begin(changed, settings); }, {named});
    }
}

}  // namespace gloam::effect::study_frames_test
