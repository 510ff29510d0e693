// SPDX-License-Identifier: MIT
#include <cmath>

#include "scene/internal/built_in_scenes.hpp"
#include "scene/primitives.hpp"
#include "scene/rigid_motion.hpp"

namespace gloam::scene {
namespace {

// 128 km away: floats are 1/128 apart on each axis. Static objects consist of exact multiples of that.
constexpr glm::dvec3 there{98304.0, 512.0, -81920.0};

Mesh make_terrace() {
    Mesh mesh = make_parallelogram(there + glm::dvec3(-8, 0, -8), {0, 0, 16}, {16, 0, 0}, 1.0);
    const auto add = [&](const glm::dvec3& low, const glm::dvec3& high) {
        append(mesh, make_box(there + low, there + high, 16.0));
    };
    add({-8, 0, -4}, {8, 3, -3.5});
    for (int i = -2; i <= 2; ++i) add({1.5 * i - 0.25, 0, -3.5}, {1.5 * i + 0.25, 2.5, -3.25});
    for (int i = 0; i < 5; ++i) add({-3, 0.25 * i, -1.5 - 0.375 * i}, {-1, 0.25 * (i + 1), -3.25});
    add({0.5, 0, -2}, {1.5, 1, -1});
    add({0.75, 1, -1.75}, {1.25, 1.5, -1.25});
    return mesh;
}

}  // namespace

Scene make_far() {
    Scene scene{.name = "far", .mesh = make_terrace()};
    // Round objects have an object space of their own, so that their shape stays exact.
    scene.objects.push_back({make_sphere({0, 0, 0}, 0.5, 48, 96),
                             [](int) { return rigid_motion(there + glm::dvec3(-0.4, 0.5, -0.5)); }});
    scene.objects.push_back({make_sphere({0, 0, 0}, 0.25, 48, 96), [](int frame) {
                                 const double x = 2.0 + 0.6 * std::sin(0.02 * frame);
                                 return rigid_motion(there + glm::dvec3(x, 0.25, -0.2), -x / 0.25, {0, 0, 1});
                             }});
    scene.camera = {.eye = there + glm::dvec3(1.2, 1.6, 3.2),
                    .target = there + glm::dvec3(-0.1, 0.6, -1.5),
                    .fovy_rad = 0.8,
                    .near = 0.1,
                    .far = 60.0,
                    .reversed_z = true};
    // Moves by less than the spacing of floats from frame to frame.
    scene.camera_path = [start = scene.camera](int frame) {
        Camera camera = start;
        camera.eye += glm::dvec3(-0.4 * std::sin(0.01 * frame), 0.0, 0.1 * std::sin(0.013 * frame));
        return camera;
    };
    scene.ao_radius = 0.4;
    return scene;
}

}  // namespace gloam::scene
