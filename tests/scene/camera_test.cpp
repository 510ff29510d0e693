// SPDX-License-Identifier: MIT
#include "scene/camera.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test::camera_test {

constexpr double endless{infinity};
constexpr double aspect = 1.5;

TEST(Camera, ViewTakesTheEyeToTheOriginAndLooksAlongMinusZ) {
    const glm::dmat4 view(make_frame({.eye = {0, 1, 0}, .target = {3, 1, 0}}, aspect).view);
    for (const auto& [world, seen] :
         {std::pair<glm::dvec3, glm::dvec3>({0, 1, 0}, {0, 0, 0}), {{5, 2, 2}, {2, 1, -5}}})
        EXPECT_LT(glm::distance(glm::dvec3(view * glm::dvec4(world, 1.0)), seen), 1e-6);
}

// Depths of the nearest plane, of the middle of the depth buffer and of the farthest plane; a corner of the
// view is right, and up, which is -1 in Vulkan's device coordinates.
void expect_projection(const Camera& camera, double middle) {
    const CameraFrame frame = make_frame(camera, aspect);
    const bool orthographic = camera.projection == Projection::orthographic;
    const glm::dmat4 vk(frame.proj_vk);
    const glm::dmat4 gl = gl_from_vk(vk);
    const double near_value = camera.reversed_z ? 1.0 : 0.0;
    for (const auto& [depth, value] :
         {std::pair{camera.near, near_value}, {middle, 0.5}, {std::min(camera.far, 1e9), 1.0 - near_value}}) {
        const double top = orthographic ? 0.5 * camera.view_height : depth * std::tan(0.5 * camera.fovy_rad);
        const glm::dvec4 corner(aspect * top, top, -depth, 1.0);
        const glm::dvec4 clip = vk * corner;
        EXPECT_LT(glm::distance(glm::dvec3(clip) / clip.w, glm::dvec3(1.0, -1.0, value)), 2e-6) << depth;
        const glm::dvec4 of_gl = gl * corner;
        EXPECT_LT(glm::distance(glm::dvec3(of_gl) / of_gl.w, glm::dvec3(1.0, 1.0, 2.0 * value - 1.0)), 4e-6);
    }
    for (int i = 0; i < 16; ++i) EXPECT_NEAR(vk_from_gl(gl)[i / 4][i % 4], vk[i / 4][i % 4], 1e-15);
    EXPECT_EQ(frame.orthographic(), orthographic);
    EXPECT_EQ(frame.p00_p11(), glm::vec2(vk[0][0], vk[1][1]));
    // A unit in the last place of an element near 1, over the slope 1 / (far - near) or steeper.
    const Planes planes = planes_of(frame.proj_vk);
    EXPECT_NEAR(planes.near, camera.near, 0x1p-23 * 20.0);
    EXPECT_NEAR(1.0 / planes.far, 1.0 / camera.far, 0x1p-23 / 0.5);
    EXPECT_EQ(std::isinf(planes.far), std::isinf(camera.far));
    EXPECT_EQ(planes.reversed_z, camera.reversed_z);
}

TEST(Camera, ProjectsItsCornersAndPlanes) {
    for (const bool reversed : {false, true}) {
        expect_projection({.fovy_rad = 1.2, .near = 0.5, .far = 20.0, .reversed_z = reversed}, 20.0 / 20.5);
        expect_projection({.near = 0.5, .far = endless, .reversed_z = reversed}, 1.0);
        expect_projection({.projection = Projection::orthographic,
                           .view_height = 4.0,
                           .near = 0.5,
                           .far = 20.0,
                           .reversed_z = reversed},
                          10.25);
    }
}

TEST(Camera, Impossible) {
    const std::vector<Camera> cameras{
        {.eye = {1, 1, 1}, .target = {1, 1, 1}},
        {.eye = {nan, 0, 0}},
        {.eye = {endless, 0, 0}},
        {.target = {0, 3, 0}},
        {.up = {0, 0, 0}},
        {.fovy_rad = 0.0},
        {.fovy_rad = 3.15},
        {.fovy_rad = nan},
        {.near = 0.0},
        {.near = -1.0},
        {.near = 5.0, .far = 5.0},
        {.far = nan},
        {.near = endless, .far = endless},
    };
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        SCOPED_TRACE(i);
        expect_error<std::invalid_argument>([&] { (void)make_frame(cameras[i], aspect); }, {"camera"});
    }
    for (const double bad : {0.0, -1.0, double{nan}, endless})
        expect_error<std::invalid_argument>([&] { (void)make_frame({}, bad); }, {"camera", "aspect"});
}

}  // namespace gloam::scene::test::camera_test
