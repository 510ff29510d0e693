// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "scene/internal/built_in_scenes.hpp"
#include "scene/primitives.hpp"

namespace gloam::scene {
namespace {

// A trefoil knot, upright.
glm::dvec3 trefoil(double part) {
    const double t = 2.0 * std::numbers::pi * part;
    return {std::sin(t) + 2.0 * std::sin(2.0 * t), std::cos(t) - 2.0 * std::cos(2.0 * t), -std::sin(3.0 * t)};
}

}  // namespace

Scene make_knot() {
    Mesh knot = make_tube(trefoil, 0.55, 240, 32);
    constexpr double scale = 0.17;
    knot = placed(std::move(knot), scale, {0, -scale * bounds_of(knot).low.y, 0});
    Scene scene{.name = "knot", .mesh = std::move(knot)};
    append(scene.mesh, make_parallelogram({-6, 0, -0.45}, {0, 0, 6.45}, {12, 0, 0}, 0.5));  // the ground
    append(scene.mesh, make_parallelogram({-6, 0, -0.45}, {12, 0, 0}, {0, 6, 0}, 0.5));     // the wall
    scene.camera = {.eye = {0.9, 0.95, 2.0},
                    .target = {0, 0.48, 0},
                    .fovy_rad = 0.7,
                    .near = 0.1,
                    .far = 40.0,
                    .reversed_z = true};
    scene.camera_path = [start = scene.camera](int frame) {
        Camera camera = start;
        const double angle = std::atan2(0.9, 2.0) + 0.5 * (std::cos(0.02 * frame) - 1.0);
        const double distance = std::hypot(0.9, 2.0);
        camera.eye = {distance * std::sin(angle), start.eye.y, distance * std::cos(angle)};
        return camera;
    };
    scene.ao_radius = 0.25;
    return scene;
}

}  // namespace gloam::scene
