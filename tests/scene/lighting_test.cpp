// SPDX-License-Identifier: MIT
#include "scene/lighting.hpp"

#include <cmath>
#include <limits>

#include "scene/primitives.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test {
namespace lighting_test {

constexpr gpu::Extent size{33, 33};

// A floor, and a ball above its middle; seen from right above, so that no pixel sees what is below the ball.
Scene ball_on_floor() {
    Scene scene{.name = "ball", .mesh = make_parallelogram({-20, 0, 20}, {40, 0, 0}, {0, 0, -40}, 40.0)};
    append(scene.mesh, make_sphere({0, 2, 0}, 0.5, 32, 64));
    scene.camera = {.eye = {0, 8, 0}, .target = {0, 0, 0}, .up = {0, 0, -1}, .fovy_rad = 1.2};
    return scene;
}

// The floor of the scene as that camera sees it, the ball left out.
GBuffer floor_view(const Scene& scene) {
    const std::size_t pixels = std::size_t{size.width} * size.height;
    return {.extent = size,
            .depth = std::vector<float>(pixels, 8.0F),
            .normal = std::vector<glm::vec3>(pixels, glm::vec3(0, 0, 1)),
            .camera = make_frame(scene.camera, 1.0)};
}

float brightness(const glm::vec3& color) {
    return color.x + color.y + color.z;
}

TEST(Lighting, TheBallThrowsItsShadowAwayFromTheSun) {
    const Scene scene = ball_on_floor();
    const SplitLight with = light_of(floor_view(scene), &scene);
    const SplitLight without = light_of(floor_view(scene), nullptr);
    std::size_t dark = 0;
    double x = 0.0;
    for (std::size_t i = 0; i < with.direct.size(); ++i) {
        ASSERT_LE(brightness(with.direct[i]), brightness(without.direct[i]) + 1e-5F);
        EXPECT_EQ(with.ambient[i], without.ambient[i]);  // shadows are of the direct light
        if (brightness(with.direct[i]) > 0.01F) continue;
        ++dark;
        x += static_cast<double>(i % size.width) - 16.0;
    }
    ASSERT_GT(dark, 3U);
    EXPECT_LT(dark, 60U);
    EXPECT_GT(x / static_cast<double>(dark), 1.0);  // the sun stands at -x
}

TEST(Lighting, ALampLightsWhatFacesIt) {
    Scene scene = ball_on_floor();
    scene.lamp = glm::dvec3(0, 6, 0);
    const SplitLight lit = light_of(floor_view(scene), &scene);
    EXPECT_EQ(brightness(lit.direct[16 * 33 + 16]), 0.0F);  // below the ball
    EXPECT_GT(brightness(lit.direct[16 * 33 + 28]), 0.1F);
    scene.lamp = glm::dvec3(0, -6, 0);  // under the floor
    for (const glm::vec3& color : light_of(floor_view(scene), &scene).direct)
        EXPECT_EQ(brightness(color), 0.0F);
}

TEST(Lighting, TheBackgroundIsSkyAndHasNoOcclusion) {
    const Scene scene = ball_on_floor();
    GBuffer view = floor_view(scene);
    view.depth[0] = std::numeric_limits<float>::infinity();
    view.depth[1] = std::nanf("");
    const SplitLight light = light_of(view, &scene);
    for (const std::size_t i : {0, 1}) {
        EXPECT_EQ(light.ambient[i], glm::vec3(0));
        EXPECT_GT(brightness(light.direct[i]), 1.0F);
    }
}

TEST(Lighting, AlbedoAndMissingNormals) {
    const Scene scene = ball_on_floor();
    GBuffer view = floor_view(scene);
    const SplitLight grey = light_of(view, &scene);
    view.color.assign(view.depth.size(), glm::vec3(default_color.x, 0.0F, 0.0F));
    const SplitLight red = light_of(view, &scene);
    view.normal.clear();  // the depth is that of a plane
    const SplitLight found = light_of(view, &scene);
    for (std::size_t i = 0; i < red.ambient.size(); ++i) {
        EXPECT_FLOAT_EQ(red.ambient[i].x, grey.ambient[i].x);
        EXPECT_EQ(red.ambient[i].y, 0.0F);
        EXPECT_NEAR(found.ambient[i].x, red.ambient[i].x, 1e-4F);
    }
}

TEST(Lighting, IsTheSameForAnyNumberOfThreads) {
    const Scene scene = ball_on_floor();
    const SplitLight one = light_of(floor_view(scene), &scene, {.threads = 1});
    const SplitLight four = light_of(floor_view(scene), &scene, {.threads = 4});
    EXPECT_EQ(one.direct, four.direct);
    EXPECT_EQ(one.ambient, four.ambient);
}

TEST(Lighting, RefusesImagesOfAnotherSize) {
    const Scene scene = ball_on_floor();
    GBuffer view = floor_view(scene);
    view.normal.resize(5);
    expect_error<std::invalid_argument>([&] { (void)light_of(view, &scene); }, {"5 normals"});
}

}  // namespace lighting_test
}  // namespace gloam::scene::test
