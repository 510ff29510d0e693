// SPDX-License-Identifier: MIT
// Light over several frames: its history and its filter.
#include <glm/gtc/matrix_transform.hpp>

#include "backend/vulkan/commands.hpp"
#include "directions.hpp"
#include "effect/composite.hpp"
#include "reference/geometry_camera.hpp"

namespace gloam::effect::light_frames_test {

class LightFrames : public Directions {};

double rmse(const std::vector<glm::vec3>& found, const std::vector<glm::vec3>& wanted) {
    double sum = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i)
        sum += std::pow(double{glm::distance(found[i], wanted[i])}, 2.0);
    return std::sqrt(sum / static_cast<double>(found.size()));
}

Settings unfiltered(std::uint32_t samples) {
    Settings settings = many();
    settings.samples = samples;
    settings.weight_max = 512.0F;
    settings.filter = Filter::none;
    return settings;
}

TEST_F(LightFrames, LightOfAStillViewConverges) {
    const scene::GBuffer view = rasterized("corner", {64, 36}, {.color = true});
    const scene::Environment sky = scene::sky_environment();
    const DirectionalLight wanted = directional_.light(view, many(), sky);
    const Settings settings = unfiltered(16);
    const DirectionalLight first = directional_.light(view, settings, sky);
    DirectionalLight last;
    for (int i = 1; i < 32; ++i) last = directional_.light(view, settings, sky, LightFollows::same_view);
    EXPECT_LT(rmse(last.direct, wanted.direct), 0.15 * rmse(first.direct, wanted.direct));
    EXPECT_LT(rmse(last.bounced, wanted.bounced), 0.15 * rmse(first.bounced, wanted.bounced));
    EXPECT_EQ(directional_.light(view, settings, sky).direct, first.direct) << "a cut forgets";
    Settings alone = settings;
    alone.history = false;
    const DirectionalLight next = directional_.light(view, alone, sky, LightFollows::same_view);
    EXPECT_EQ(next.direct, first.direct) << "without a history each frame is the first";
    alone.filter = Filter::convergence;  // what bounces keeps the walls' colours; it is hardly blurred
    const DirectionalLight smooth = directional_.light(view, alone, sky);
    EXPECT_LT(rmse(smooth.bounced, wanted.bounced), 1.3 * rmse(first.bounced, wanted.bounced));
}

// In the first frame the kernels' rotations repeat along some columns of an image of 1280 pixels.
TEST_F(LightFrames, LightHasNoSeamWhereThePatternRepeats) {
    constexpr std::size_t width = 1280;
    constexpr std::size_t height = 24;
    scene::GBuffer view{.extent = {width, height},
                        .depth = std::vector(width * height, 3.0F),
                        .normal = std::vector(width * height, glm::vec3(0, 0, 1))};
    view.camera = scene::make_frame({.projection = scene::Projection::orthographic, .view_height = 2.0},
                                    double{width} / double{height});
    scene::Environment sides{.extent = {2, 1}, .radiance = {{1, 0, 0}, {0, 1, 0}}};
    const auto worst_column = [&](const DirectionalLight& light) {
        float worst = 0.0F;
        for (std::size_t x = 0; x < width; ++x) {
            float mean = 0.0F;
            for (std::size_t y = 0; y < height; ++y) mean += light.direct[width * y + x].x / float{height};
            worst = std::max(worst, std::abs(mean - 0.5F));
        }
        return worst;
    };
    const Settings settings = unfiltered(8);
    DirectionalLight light = directional_.light(view, settings, sides);
    const float first = worst_column(light);
    EXPECT_GT(first, 0.1F);
    for (int i = 1; i < 16; ++i) light = directional_.light(view, settings, sides, LightFollows::same_view);
    EXPECT_LT(worst_column(light), 0.1F * first);
}

// On a plane between two lights all pixels have the same light.
TEST_F(LightFrames, TheFilterSmoothsTheFirstFrameOfLight) {
    const scene::GBuffer plane = step(3.0F, 3.0F);
    const scene::Environment sides{.extent = {2, 1}, .radiance = {{1, 0, 0}, {0, 1, 0}}};
    const auto noise = [](const DirectionalLight& light) {
        glm::vec3 mean(0);
        for (const glm::vec3& color : light.direct) mean += color / static_cast<float>(light.direct.size());
        return rmse(light.direct, std::vector(light.direct.size(), mean));
    };
    Settings settings = unfiltered(8);
    const double rough = noise(directional_.light(plane, settings, sides));
    settings.filter = Filter::convergence;
    EXPECT_LT(noise(directional_.light(plane, settings, sides)), 0.4 * rough);
}

// A camera and objects that move: the history follows the surfaces, and objects leave no trail of light.
TEST_F(LightFrames, LightFollowsWhatMoves) {
    const scene::Scene scene = scene::make_scene("moving");
    Settings settings = unfiltered(16);
    settings.radius = static_cast<float>(scene.ao_radius);
    const scene::Environment sky = scene::sky_environment();
    const auto last_of = [&](const Settings& with, bool follows) {
        DirectionalLight light;
        for (int i = 0; i < 12; ++i) {
            const scene::GBuffer view = rasterized(scene, {96, 54}, {.frame = i, .motion = true});
            light = directional_.light(view, with, sky,
                                       follows ? LightFollows::last_view : LightFollows::nothing);
        }
        return light;
    };
    Settings exact = settings;
    exact.samples = 1024;
    const DirectionalLight wanted = last_of(exact, false);
    const double alone = rmse(last_of(settings, false).direct, wanted.direct);
    const double followed = rmse(last_of(settings, true).direct, wanted.direct);
    Settings blind = settings;
    blind.invalidation = Invalidation::none;
    blind.depth_tolerance = 1e9F;
    EXPECT_LT(followed, 0.6 * alone);
    EXPECT_LT(followed, 0.9 * rmse(last_of(blind, true).direct, wanted.direct));
}

// Under an even sky the light of a plane's pixel is that of its samples' elevations, the same in all pixels.
// The half that stays has the mean of two frames, the half that comes into view the second frame's.
TEST_F(LightFrames, LightOfWhatComesIntoViewHasNoHistory) {
    const scene::Environment white = scene::constant_environment({1, 1, 1});
    scene::GBuffer plane = step(3.0F, 3.0F);
    const auto halves_of = [&](LightFollows follows) {
        glm::vec2 sums(0);
        const DirectionalLight light = directional_.light(plane, unfiltered(1), white, follows);
        for (std::size_t i = 0; i < light.direct.size(); ++i)
            (i % 48 < 24 ? sums.x : sums.y) += light.direct[i].x;
        return sums / (24.0F * 32.0F);
    };
    const float first = halves_of(LightFollows::nothing).x;
    plane.camera.previous_from_current = glm::translate(glm::mat4(1.0F), glm::vec3(6.0F, 0.0F, 0.0F));
    const glm::vec2 second = halves_of(LightFollows::last_view);
    EXPECT_NEAR(second.y, 2.0F * second.x - first, 0.01F);
    EXPECT_GT(second.y, 0.1F);
}

// What comes to stand beside a point darkens it at once.
TEST_F(LightFrames, AShadowComesWithWhatCastsIt) {
    const scene::Environment white = scene::constant_environment({1, 1, 1});
    const Settings settings = unfiltered(64);
    const scene::GBuffer open = step(3.0F, 3.0F, close);
    scene::GBuffer blocked = step(3.0F - high, 3.0F, close);
    blocked.camera.previous_from_current = glm::mat4(1.0F);
    const reference::GloamCamera camera{glm::dvec2(open.camera.p00_p11()), {48, 32}, true};
    for (std::size_t i = 0; i < open.depth.size(); ++i)
        blocked.previous_position.emplace_back(
            reference::gloam_camera_position(glm::ivec2(i % 48, i / 48), double{open.depth[i]}, camera));
    const float fresh = directional_.light(blocked, settings, white).direct[beside].x;
    for (int i = 0; i < 8; ++i)
        (void)directional_.light(open, settings, white,
                                 i == 0 ? LightFollows::nothing : LightFollows::same_view);
    const DirectionalLight after = directional_.light(blocked, settings, white, LightFollows::last_view);
    EXPECT_LT(after.direct[beside].x, 1.2F * fresh);
}

class CompositePass : public OnDevice<testing::Test> {
  protected:
    Composite composite_{device_, passes_};
};

// ISSAO-2 and direct light, in an image whose sides are no multiples of a group's.
TEST_F(CompositePass, OcclusionDarkensTheAmbientLightAlone) {
    const gpu::Extent extent{37, 21};
    const scene::GBuffer view = rasterized("corner", extent, {.color = true});
    const scene::SplitLight light = scene::light_of(view, nullptr);
    const auto open = composite_.lit(extent, light, {});
    const auto quarter = composite_.lit(extent, light, std::vector<float>(open.size(), 0.25F));
    const auto closed = composite_.lit(extent, light, std::vector<float>(open.size(), 1.0F));
    ASSERT_EQ(open.size(), view.depth.size());
    float brightest = 0.0F;
    for (std::size_t i = 0; i < open.size(); ++i) {
        brightest = std::max(brightest, light.ambient[i].x);
        for (int c = 0; c < 3; ++c) {
            EXPECT_FLOAT_EQ(open[i][c], light.direct[i][c] + light.ambient[i][c]);
            EXPECT_FLOAT_EQ(quarter[i][c], light.direct[i][c] + 0.75F * light.ambient[i][c]);
            EXPECT_FLOAT_EQ(closed[i][c], light.direct[i][c]);
        }
    }
    EXPECT_GT(brightest, 0.1F);
}

// Each pixel has its own occlusion. Values outside [0, 1] are clamped, and NaN counts as 0.
TEST_F(CompositePass, EachPixelHasItsOwnOcclusion) {
    const scene::SplitLight light{.ambient = std::vector<glm::vec3>(5, glm::vec3(1, 2, 4)),
                                  .direct = std::vector<glm::vec3>(5, glm::vec3(0.5F, 0, 0))};
    const std::vector<float> occlusion{0.0F, 0.5F, 1.5F, -1.0F, nan};
    const auto lit = composite_.lit({5, 1}, light, occlusion);
    EXPECT_EQ(lit[0], glm::vec3(1.5F, 2, 4));
    EXPECT_EQ(lit[1], glm::vec3(1.0F, 1, 2));
    EXPECT_EQ(lit[2], glm::vec3(0.5F, 0, 0));
    EXPECT_EQ(lit[3], glm::vec3(1.5F, 2, 4));
    EXPECT_EQ(lit[4], glm::vec3(1.5F, 2, 4));
}

// GTAO-bounce in the place of ISSAO-2.
TEST_F(CompositePass, BrightBlockersSendLight) {
    const scene::SplitLight light{.ambient = std::vector<glm::vec3>(2, glm::vec3(1, 2, 4)),
                                  .direct = std::vector<glm::vec3>(2, glm::vec3(0.5F, 0, 0))};
    const auto lit = composite_.lit({2, 1}, light, std::vector<float>{0.5F, 0.0F},
                                    std::vector<glm::vec3>(2, {0, 0.5F, 1}));
    const glm::vec3 expected(0.5F + 0.5F, 2 * 0.68096F, 4 * 0.8979F);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(lit[0][c], expected[c], 5e-4F) << c;
    EXPECT_EQ(lit[1], glm::vec3(1.5F, 2, 4));
}

TEST_F(CompositePass, RefusesImagesOfAnotherSize) {
    const scene::SplitLight light{.ambient = std::vector<glm::vec3>(6), .direct = std::vector<glm::vec3>(6)};
    const auto with = [&](gpu::Extent extent, std::size_t occlusions) {
        return
            [&, extent, occlusions] { (void)composite_.lit(extent, light, std::vector<float>(occlusions)); };
    };
    EXPECT_THAT(with({3, 2}, 4), ThrowsMessage<std::invalid_argument>(HasSubstr("4 occlusions")));
    EXPECT_THAT(with({3, 3}, 0),
                ThrowsMessage<std::invalid_argument>(HasSubstr("6 pixels with ambient light")));
}

}  // namespace gloam::effect::light_frames_test
