// SPDX-License-Identifier: MIT
// Sequences of the frame of three short passes: what they gain, and what ends a history.
#include <glm/gtc/matrix_transform.hpp>

#include "effect/errors.hpp"
#include "on_device.hpp"
#include "scene/truth.hpp"
#include "support/poison.hpp"
#include "surface_views.hpp"

namespace gloam::effect::sequence_test {

constexpr backend::Extent small{96, 54};
constexpr float radius = 1.0F;

class Sequences : public OnDevice<testing::TestWithParam<Preset>> {
  protected:
    [[nodiscard]] static Settings settings(bool history, float of_radius = radius) {
        return with(with_radius(GetParam().settings, of_radius),
                    std::string("output=r32f bent_normals=on history=") + (history ? "on" : "off"));
    }
    [[nodiscard]] std::vector<float> single(const scene::GBuffer& view, float of_radius = radius) const {
        return run(view, settings(false, of_radius)).filtered;
    }
    // The last of these frames.
    [[nodiscard]] std::vector<float> sequence(const std::vector<scene::GBuffer>& views) const {
        return run(views, settings(true)).back().filtered;
    }
};

// Where nothing is known of a frame before, it is a single frame.
TEST_P(Sequences, BeginAnewWhereTheHistoryEnds) {
    const std::vector<scene::GBuffer> views = sequence_of("moving", small, 3);
    scene::GBuffer cut = views[2];
    cut.camera.previous_from_current.reset();
    scene::GBuffer larger = drawn("moving", {83, 45}, {.frame = 2});
    const std::vector<float> expected = single(cut);
    const auto same = [](const std::vector<float>& shown, const std::vector<float>& wanted) {
        return errors_of(shown, wanted).rmse < 0.002;
    };
    EXPECT_TRUE(same(sequence({cut}), expected));
    EXPECT_TRUE(same(sequence({views[0], views[1], cut}), expected));
    AmbientOcclusion& effect = shared_effect();
    effect.begin(views[1], settings(true));
    (void)effect.next();
    effect.advance(larger);
    const std::vector<float> resized = effect.next().filtered;  // single() takes the effect for another view
    EXPECT_TRUE(same(resized, single(larger)));
    EXPECT_FALSE(same(sequence(views), expected));
    effect.begin(views[1], settings(true));
    (void)effect.next();
    effect.begin(views[2], settings(true));
    EXPECT_TRUE(same(effect.next().filtered, expected));
    effect.begin(views[2], settings(true, 2.0F * radius));
    const std::vector<float> wider = effect.next().filtered;
    EXPECT_TRUE(same(wider, single(cut, 2.0F * radius)));
}

// A camera that jumps: the engine still names the camera that stood where the last one did not.
TEST_P(Sequences, AJumpKeepsNothing) {
    std::vector<scene::GBuffer> views = sequence_of("moving", small, 8);
    const scene::GBuffer after = views[7];
    views.assign({views[0], views[1], views[2], after});
    EXPECT_LT(errors_of(sequence(views), single(after)).rmse, 0.002);
}

// What stands still converges to what as many slices in one frame give: its error against traced rays is
// theirs.
TEST_P(Sequences, AStillViewConverges) {
    const scene::GBuffer& view = drawn("columns", small);
    Settings many = settings(false);
    many.samples *= std::min(64U, most_samples / many.samples);
    const std::vector<float> wanted = run(view, many).filtered;
    const scene::TruthSettings traced{.rays = {.radius = double{radius}, .rays = 256}};
    const Truth limit =
        truth_from(view, scene::trace_geometry(scene::make_scene("columns"), 0, view, traced).occlusion);
    const std::vector<float> shown = sequence(std::vector<scene::GBuffer>(64, view));
    EXPECT_LT(errors_of(shown, limit).rmse, 1.02 * errors_of(wanted, limit).rmse);
    if (many.resolution == Resolution::tiles) return;  // at half size it has one slice, however many in full
    EXPECT_LT(errors_of(shown, wanted).rmse, 0.2 * errors_of(single(view), wanted).rmse);
}

// A history follows a camera that moves, and lowers the noise where it moves slowly.
TEST_P(Sequences, AMovingViewIsFollowed) {
    std::vector<scene::GBuffer> views = sequence_of("moving", small, 9);
    const auto limit_of = [&](const scene::GBuffer& view) {
        return truth_from(view, sequence(std::vector<scene::GBuffer>(32, view)));
    };
    EXPECT_LT(errors_of(sequence(views), limit_of(views[8])).rmse,
              1.6 * errors_of(single(views[8]), limit_of(views[8])).rmse);
    scene::Scene scene = scene::make_scene("columns");
    scene.camera_path = {};
    views = {drawn(scene, small)};
    while (views.size() < 9) {
        scene.camera.eye.x += 1e-3;
        scene.camera.target.x += 1e-3;
        views.push_back(drawn(scene, small));
        views.back().camera.previous_from_current = glm::translate(glm::mat4(1.0F), {1e-3F, 0.0F, 0.0F});
    }
    EXPECT_LT(errors_of(sequence(views), limit_of(views[8])).rmse,
              0.9 * errors_of(single(views[8]), limit_of(views[8])).rmse);
}

// A box before a wall that stands, seen by a camera that stands: what comes and goes is shown at once.
TEST_P(Sequences, WhatEntersIsSeenAtOnce) {
    const scene::GBuffer empty = wall(small, 3.0F);
    scene::GBuffer entered = empty;
    for (std::size_t y = 16; y < 40; ++y)
        for (std::size_t x = 31; x < 60; ++x) entered.depth[small.width * y + x] = 2.6F;
    std::vector<scene::GBuffer> views(40, empty);
    views.insert(views.end(), 2, entered);
    EXPECT_LT(errors_of(sequence(views), single(entered)).rmse, 0.06);
    EXPECT_GT(mean_of(single(entered)), 0.015);
    views.insert(views.end(), 2, empty);
    EXPECT_LT(mean_of(sequence(views)), 0.01);
}

// No bits in an engine's images leave the range, or spoil the frames after.
TEST_P(Sequences, PoisonDoesNotStay) {
    const scene::GBuffer& clean = drawn("columns", small);
    scene::GBuffer poisoned = clean;
    test::poison(poisoned);
    const Frame last = run({clean, poisoned, clean, poisoned}, settings(true)).back();
    for (std::size_t i = 0; i < last.filtered.size(); ++i) {
        ASSERT_TRUE(last.filtered[i] >= 0.0F && last.filtered[i] <= 1.0F) << i;
        ASSERT_LE(glm::length(last.bent[i]), i % 7 == 0 ? 0.01F : 1.6F) << i;
    }
    std::vector<scene::GBuffer> views(10, clean);
    views[1] = poisoned;
    EXPECT_LT(errors_of(sequence(views), sequence(std::vector<scene::GBuffer>(10, clean))).rmse, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Names, Sequences, testing::ValuesIn(frames_of_all_resolutions()), preset_name);

}  // namespace gloam::effect::sequence_test
