// SPDX-License-Identifier: MIT
// Projections that move by a part of a pixel from frame to frame, as temporal antialiasing wants them: TAA,
// DLSS, FSR.
#include "effect/errors.hpp"
#include "on_device.hpp"
#include "reference/sampling.hpp"
#include "surface_views.hpp"

namespace gloam::effect::moving_frames_test {

constexpr backend::Extent extent{240, 150};
constexpr int frame_count = 32;

// From the middle of a pixel to a point of it, in pixels: Halton's.
glm::dvec2 point_of(unsigned frame) {
    return reference::gloam_halton_2d(frame + 1) - 0.5;
}

// Depth of a board on a floor before a wall. ray: of a pixel, at depth 1. eye: how far it has moved to the
// right.
double depth_under(glm::dvec2 ray, double eye) {
    const glm::dvec2 board = 3.2 * ray + glm::dvec2(eye, 0.6);
    if (std::abs(board.x) < 0.5 && std::abs(board.y) < 0.4) return 3.2;
    return ray.y < -0.2 ? -1.0 / ray.y : 5.0;
}

// What an engine does with its jitter.
enum class Case { none, left_out, reprojected };

// The jitter of a frame, in view space at depth 1.
glm::dvec2 jitter_of(int frame) {
    const glm::dvec2 scale(wall(extent, 1.0F).camera.p00_p11());
    return 2.0 * point_of(static_cast<unsigned>(std::max(frame, 0))) /
           glm::dvec2(extent.width, extent.height) / scale;
}

// To the view space in which the jittered image has its camera in the middle.
glm::dmat4 sheared(glm::dvec2 jitter) {
    glm::dmat4 shear(1.0);
    shear[2] = glm::dvec4(jitter, 1.0, 0.0);
    return shear;
}

// A frame of a camera that moves so far to the right each frame; its normals come from depth.
scene::GBuffer view_of_frame(int frame, double speed, Case jitters) {
    const glm::dvec2 jitter = jitters == Case::none ? glm::dvec2(0.0) : jitter_of(frame);
    scene::GBuffer view =
        view_of(extent, false, [&](glm::dvec2 ray) { return depth_under(ray + jitter, speed * frame); });
    view.normal.clear();
    const glm::dvec2 element = jitter * glm::dvec2(view.camera.p00_p11());
    view.camera.proj_vk[2][0] = static_cast<float>(element.x);
    view.camera.proj_vk[2][1] = static_cast<float>(element.y);
    glm::dmat4 moved(1.0);
    moved[3][0] = speed;
    if (jitters == Case::reprojected) moved = sheared(jitter_of(frame - 1)) * moved * sheared(-jitter);
    view.camera.previous_from_current = glm::mat4(moved);
    return view;
}

using Jitter = OnDevice<testing::Test>;

// Reprojected, or left out of the camera's motion: of the last frame of a sequence.
TEST_F(Jitter, ChangesLittle) {
    for (const char* preset : {"balanced", "fast"})
        for (const double speed : {0.0, 0.004}) {
            const auto last = [&](Case jitters) {
                std::vector<scene::GBuffer> views;
                for (int i = 0; i < frame_count; ++i) views.push_back(view_of_frame(i, speed, jitters));
                return run(views, with_radius(preset_named(preset).settings, 0.5F)).back().filtered;
            };
            const std::vector<float> plain = last(Case::none);
            for (const Case jitters : {Case::left_out, Case::reprojected})
                EXPECT_LT(errors_of(last(jitters), plain).rmse, 0.012) << preset << ' ' << speed;
        }
}

}  // namespace gloam::effect::moving_frames_test
