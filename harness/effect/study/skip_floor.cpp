// SPDX-License-Identifier: MIT
#include "effect/study/skip_floor.hpp"

#include "scene/primitives.hpp"

namespace gloam::effect {

scene::Scene skip_floor() {
    scene::Scene scene{.name = "floor",
                       .mesh = scene::make_parallelogram({-40, 0, -60}, {0, 0, 70}, {80, 0, 0}, 1.0)};
    scene.camera = {.eye = {0, 1.7, 0}, .target = {0, 0, -3.0}, .fovy_rad = 0.9, .near = 0.1, .far = 200.0};
    scene.camera_path = [start = scene.camera](int frame) {
        scene::Camera camera = start;
        camera.eye.z -= 0.02 * frame;
        camera.target.z -= 0.02 * frame;
        return camera;
    };
    return scene;
}

}  // namespace gloam::effect
