// SPDX-License-Identifier: MIT
// The light of pictures.
#include "pictures/light.hpp"

#include "effect/surface_views.hpp"
#include "scene/support.hpp"

namespace gloam::pictures::light_test {

using effect::plane;
using effect::wall;
using namespace scene;

// A view of walls that face the eye, with these depths.
GBuffer walls(gpu::Extent extent, const std::vector<float>& depth) {
    GBuffer view = wall(extent, 1.0F);
    view.depth = depth;
    return view;
}

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
    GBuffer view = wall(size, 8.0F);
    view.camera = make_frame(scene.camera, 1.0);
    return view;
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

// The background is sky and has no occlusion.
TEST(Lighting, AlbedoAndMissingNormals) {
    const Scene scene = ball_on_floor();
    GBuffer view = floor_view(scene);
    view.depth[0] = infinity;
    view.depth[1] = nan;
    const SplitLight grey = light_of(view, &scene);
    view.color.assign(view.depth.size(), glm::vec3(default_color.x, 0.0F, 0.0F));
    const SplitLight red = light_of(view, &scene);
    view.normal.clear();  // the depth is that of a plane
    const SplitLight found = light_of(view, &scene);
    for (std::size_t i = 0; i < red.ambient.size(); ++i) {
        EXPECT_FLOAT_EQ(red.ambient[i].x, grey.ambient[i].x);
        EXPECT_EQ(red.ambient[i].y, 0.0F);
        EXPECT_NEAR(found.ambient[i].x, red.ambient[i].x, 1e-4F);
        if (i > 1) continue;
        EXPECT_EQ(red.ambient[i].x, 0.0F);
        EXPECT_GT(brightness(grey.direct[i]), 1.0F);
    }
}

// The light of pictures at several samples of a pixel: each shows the pixel whose plane it lies on, and the
// picture is their mean.
TEST(PictureLight, ASampleShowsThePixelWhosePlaneItLiesOn) {
    // 2 x 2 pixels of 2 x 2 samples: a near wall on the left ends in the middle of the second column.
    const PictureLight edge =
        picture_light(walls({2, 2}, {1, 4, 1, 4}),
                      walls({4, 4}, {1, 4, 4, 4, 1, 4, 4, 4, 1, 1, 4, infinity, 1, 1, 4, 4}), 2, nullptr);
    EXPECT_EQ(edge.pixel, (std::vector<std::uint32_t>{0, 1, 1, 1, 0, 1, 1, 1, 2, 2, 3, 3, 2, 2, 3, 3}));
    const std::vector<float> spread = edge.spread({0.1F, 0.2F, 0.3F, 0.4F});
    std::vector<glm::vec3> samples;
    for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_EQ(spread[i], 0.1F * static_cast<float>(edge.pixel[i] + 1)) << i;
        samples.emplace_back(static_cast<float>(i));
    }
    EXPECT_THAT(edge.mean(samples),
                ElementsAre(glm::vec3(2.5F), glm::vec3(4.5F), glm::vec3(10.5F), glm::vec3(12.5F)));
    // Depths of samples differ by far more than the tolerance, and each lies on the plane.
    EXPECT_EQ(
        picture_light(plane({2, 2}, false, {-2, 0, 1}), plane({4, 4}, false, {-2, 0, 1}), 2, nullptr).pixel,
        (std::vector<std::uint32_t>{0, 0, 1, 1, 0, 0, 1, 1, 2, 2, 3, 3, 2, 2, 3, 3}));
}

}  // namespace gloam::pictures::light_test
