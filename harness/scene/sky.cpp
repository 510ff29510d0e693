// SPDX-License-Identifier: MIT
#include <cmath>

#include "scene/internal/built_in_scenes.hpp"
#include "scene/primitives.hpp"
#include "scene/rigid_motion.hpp"

namespace gloam::scene {
namespace {

// A mast with two arms, at a position on the ground.
Mesh make_mast(double x, double z) {
    Mesh mast = make_cylinder({x, 0, z}, 0.12, 7.0, 24);
    append(mast, make_box({x - 0.9, 6.2, z - 0.06}, {x + 0.9, 6.35, z + 0.06}, 1.0));
    append(mast, make_box({x - 0.6, 5.5, z - 0.06}, {x + 0.6, 5.65, z + 0.06}, 1.0));
    return mast;
}

// A straight wire of a square section from mast to mast.
Mesh make_wire(double x, double y, double z_far, double z_near) {
    return make_box({x - 0.012, y, z_far}, {x + 0.012, y + 0.024, z_near}, 1.0);
}

}  // namespace

Scene make_sky() {
    Scene scene{.name = "sky", .mesh = make_parallelogram({-150, 0, -300}, {0, 0, 310}, {300, 0, 0}, 5.0)};
    for (int i = 0; i < 8; ++i) append(scene.mesh, make_mast(-2.0, -9.0 - 18.0 * i));
    for (const double x : {-2.85, -1.15}) append(scene.mesh, make_wire(x, 6.35, -135.0, 5.0));
    for (const double x : {-2.55, -1.45}) append(scene.mesh, make_wire(x, 5.65, -135.0, 5.0));
    append(scene.mesh, make_box({4, 0, -40}, {9, 2.6, -34}, 1.0));  // a hut
    // A circling kite: its history meets the sky, which has none.
    scene.objects.push_back({make_box({-0.4, -0.03, -0.3}, {0.4, 0.03, 0.3}, 1.0), [](int frame) {
                                 const double t = 0.03 * frame;
                                 const glm::dvec3 at{1.5 + 1.2 * std::cos(t), 5.0 + std::sin(t), -9.0};
                                 return rigid_motion(at, 0.5 + 0.7 * t, {0.6, 0.8, 0});
                             }});
    scene.camera = {.eye = {0, 1.7, 0},
                    .target = {0, 4.7, -9.0},
                    .fovy_rad = 0.8,
                    .near = 0.1,
                    .far = 500.0,
                    .reversed_z = true};
    scene.camera_path = [start = scene.camera](int frame) {
        Camera camera = start;
        camera.target.x += 1.5 * std::sin(0.02 * frame);
        camera.eye.z -= 0.5 * std::sin(0.01 * frame);
        return camera;
    };
    scene.ao_radius = 0.6;
    return scene;
}

}  // namespace gloam::scene
