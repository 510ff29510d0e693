// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

// Ways in which the views' cameras move.
namespace gloam::scene::views {

// Where a view's camera starts.
struct Stand {
    glm::dvec3 eye{0};
    glm::dvec3 target{0};
    double fovy_rad = 0.9;
    double view_height = 0.0;  // > 0: orthographic, world units from bottom to top
    double near = 0.05;
    double far = 200.0;
};

// The camera at its start: reversed depth.
[[nodiscard]] Camera camera_of(const Stand& stand);

// A camera that moves by `step` in each frame, its target with it.
[[nodiscard]] std::function<Camera(int frame)> gliding(const Stand& stand, const glm::dvec3& step);

// A camera that moves by `step` in each frame and looks at the same target.
[[nodiscard]] std::function<Camera(int frame)> passing(const Stand& stand, const glm::dvec3& step);

// A camera that circles its target about the vertical axis.
[[nodiscard]] std::function<Camera(int frame)> circling(const Stand& stand, double degrees_a_frame);

// The scene with a camera path; `camera` is its frame 0.
[[nodiscard]] Scene filmed(Scene scene, std::function<Camera(int frame)> path);

}  // namespace gloam::scene::views
