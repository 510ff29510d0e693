// SPDX-License-Identifier: MIT
#include "scene/views/camera_paths.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace gloam::scene::views {

Camera camera_of(const Stand& stand) {
    Camera camera{.eye = stand.eye,
                  .target = stand.target,
                  .fovy_rad = stand.fovy_rad,
                  .near = stand.near,
                  .far = stand.far,
                  .reversed_z = true};
    if (stand.view_height > 0.0) {
        camera.projection = Projection::orthographic;
        camera.view_height = stand.view_height;
    }
    return camera;
}

std::function<Camera(int)> gliding(const Stand& stand, const glm::dvec3& step) {
    return [start = camera_of(stand), step](int frame) {
        Camera camera = start;
        camera.eye += static_cast<double>(frame) * step;
        camera.target += static_cast<double>(frame) * step;
        return camera;
    };
}

std::function<Camera(int)> passing(const Stand& stand, const glm::dvec3& step) {
    return [start = camera_of(stand), step](int frame) {
        Camera camera = start;
        camera.eye += static_cast<double>(frame) * step;
        return camera;
    };
}

std::function<Camera(int)> circling(const Stand& stand, double degrees_a_frame) {
    return [start = camera_of(stand), degrees_a_frame](int frame) {
        const double angle = frame * degrees_a_frame * std::numbers::pi / 180.0;
        const glm::dvec3 back = start.eye - start.target;
        Camera camera = start;
        camera.eye = start.target + glm::dvec3(std::cos(angle) * back.x + std::sin(angle) * back.z, back.y,
                                               std::cos(angle) * back.z - std::sin(angle) * back.x);
        return camera;
    };
}

Scene filmed(Scene scene, std::function<Camera(int)> path) {
    scene.camera = path(0);
    scene.camera_path = std::move(path);
    return scene;
}

}  // namespace gloam::scene::views
