// SPDX-License-Identifier: MIT
// The light of pictures.
#define GLM_ENABLE_EXPERIMENTAL
#include "pictures/light.hpp"
#include <glm/gtx/string_cast.hpp>

#include "effect/surface_views.hpp"
#include "scene/support.hpp"

namespace gloam::pictures::light_test {

using effect::plane;
using effect::wall;
using namespace scene;

// A view of walls that face the eye, with these depths.
GBuffer walls(backend::Extent extent, const std::vector<float>& depth) {
    GBuffer view = wall(extent, 1.0F);
    view.depth = depth;
    return view;
}

constexpr backend::Extent size{33, 33};

// A floor, and a ball above its middle; seen from right above, so that no pixel sees what is below the ball.
Scene ball_on_floor() {
    Scene scene{.name = "ball", .mesh = make_parallelogram({-20, 0, 20}, {40, 0, 0}, {0, 0, -40}, 40.0)};
    append(scene.mesh, make_sphere({0, 2, 0}, 0.5, 32));
    scene.camera = {.eye = {0, 8, 0}, .target = {0, 0, 0}, .up = {0, 0, -1}, .fovy_rad = 1.2};
    return scene;
}

// The floor of the scene as that camera sees it, the ball left out.
GBuffer floor_view(const Scene& scene) {
    GBuffer view = wall(size, 8.0F);
    view.camera = make_frame(scene.camera, 1.0);
    return view;
}

// The light of a pixel of the floor. change: of the scene and of its view.
struct Known {
    const char* what;
    std::size_t pixel;
    glm::vec3 direct, ambient;
    void (*change)(Scene& scene, GBuffer& view) = [](Scene&, GBuffer&) {};
};

constexpr std::size_t middle = 33 * 16 + 16;
constexpr std::size_t aside = middle + 12;
constexpr glm::vec3 none(0.0F);
constexpr glm::vec3 ambient_light{0.35F, 0.385F, 0.434F};
constexpr glm::vec3 sunlight{0.3049F, 0.2795F, 0.2337F};
constexpr glm::vec3 lamplight{0.35F, 0.3208F, 0.2683F};
constexpr glm::vec3 sky{0.62F, 0.67F, 0.73F};
void red(Scene&, GBuffer& view) {
    view.color.assign(view.depth.size(), {default_color.x, 0.0F, 0.0F});
}
const Known known[] = {
    {"open", aside, sunlight, ambient_light},
    {"in the ball's shadow, away from the sun", middle - 4 * 33 + 4, none, ambient_light},
    {"sky", 0, sky, none, [](Scene&, GBuffer& view) { view.depth[0] = infinity; }},
    {"no depth", 0, sky, none, [](Scene&, GBuffer& view) { view.depth[0] = nan; }},
    {"red", aside, {sunlight.x, 0, 0}, {ambient_light.x, 0, 0}, red},
    {"normals from depth", aside, sunlight, ambient_light,
     [](Scene&, GBuffer& view) { view.normal.clear(); }},
    {"under a lamp", aside, lamplight, ambient_light, [](Scene& scene, GBuffer&) { scene.lamp = {0, 6, 0}; }},
    {"below the ball", middle, none, ambient_light, [](Scene& scene, GBuffer&) { scene.lamp = {0, 6, 0}; }},
    {"over a lamp", aside, none, ambient_light, [](Scene& scene, GBuffer&) { scene.lamp = {0, -6, 0}; }}};

TEST(Lighting, OfKnownPixels) {
    for (const auto& [what, pixel, direct, ambient, change] : known) {
        Scene scene = ball_on_floor();
        GBuffer view = floor_view(scene);
        change(scene, view);
        const SplitLight light = picture_light(view, view, 1, &scene).light;
        EXPECT_LT(glm::distance(light.direct[pixel], direct), 1e-3F) << what;
        EXPECT_LT(glm::distance(light.ambient[pixel], ambient), 1e-3F) << what;
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
