// SPDX-License-Identifier: MIT
#include <cmath>

#include "scene/internal/built_in_scenes.hpp"
#include "scene/primitives.hpp"
#include "scene/rigid_motion.hpp"

namespace gloam::scene {
namespace {

// A floor, a wall with pilasters, steps in front of it.
Mesh make_background() {
    Mesh mesh = make_parallelogram({-8, 0, -3}, {0, 0, 10}, {16, 0, 0}, 1.0);
    append(mesh, make_parallelogram({-8, 0, -3}, {16, 0, 0}, {0, 6, 0}, 1.0));
    for (int i = -3; i <= 3; ++i) append(mesh, make_box({i - 0.15, 0, -3}, {i + 0.15, 6, -2.75}, 1.0));
    append(mesh, make_box({-8, 0, -2.75}, {8, 0.25, -2.25}, 1.0));
    append(mesh, make_box({-8, 0, -2.25}, {8, 0.125, -1.75}, 1.0));
    return mesh;
}

}  // namespace

Scene make_moving() {
    Scene scene{.name = "moving", .mesh = make_background()};
    // A ball rolls from side to side without slipping; a box turns while it slides the opposite way.
    constexpr double ball = 0.35;
    scene.objects.push_back({make_sphere({0, 0, 0}, ball, 48, 96), [](int frame) {
                                 const double x = 1.3 * std::sin(0.03 * frame);
                                 return rigid_motion({x, ball, -1.0}, -x / ball, {0, 0, 1});
                             }});
    scene.objects.push_back({make_box({-0.3, 0, -0.2}, {0.3, 0.7, 0.2}, 1.0), [](int frame) {
                                 const double x = -0.9 * std::cos(0.023 * frame);
                                 return rigid_motion({x, 0, -0.1}, 0.02 * frame);
                             }});
    scene.camera = {.eye = {0.3, 1.3, 3.0},
                    .target = {0, 0.5, -1.0},
                    .fovy_rad = 0.8,
                    .near = 0.1,
                    .far = 60.0,
                    .reversed_z = true};
    scene.camera_path = [start = scene.camera](int frame) {
        Camera camera = start;
        camera.eye += glm::dvec3(0.5 * std::sin(0.017 * frame), 0.0, 0.2 * std::sin(0.011 * frame));
        return camera;
    };
    scene.ao_radius = 0.4;
    return scene;
}

}  // namespace gloam::scene
