// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <cmath>
#include <stdexcept>

#include "scene/mesh_scene.hpp"
#include "scene/views/generators.hpp"

namespace gloam::scene::views {

Camera start_of(const Stand& stand) {
    Camera start{.eye = stand.eye,
                 .target = stand.target,
                 .fovy_rad = stand.lens.fovy_rad,
                 .near = stand.lens.near,
                 .far = stand.lens.far,
                 .reversed_z = true};
    if (stand.lens.view_height > 0.0) {
        start.projection = Projection::orthographic;
        start.view_height = stand.lens.view_height;
    }
    return start;
}

Camera camera_in(const Stand& stand, int frame) {
    Camera camera = start_of(stand);
    const glm::dvec3 moved = static_cast<double>(frame) * stand.step;
    const glm::dvec3 swayed = glm::sin(stand.rate * static_cast<double>(frame));
    switch (stand.way) {
        case Way::gliding:
            camera.eye += moved;
            camera.target += moved;
            break;
        case Way::passing:
            camera.eye += moved;
            break;
        case Way::circling:
            camera.eye = stand.target + upright_turn(frame * stand.step.x * std::numbers::pi / 180.0) *
                                            (stand.eye - stand.target);
            break;
        case Way::swaying:
            camera.eye += stand.step * swayed;
            camera.target += stand.aim * swayed;
            break;
        case Way::swinging: {
            const double angle = std::atan2(stand.eye.x, stand.eye.z) + 0.5 * (std::cos(0.02 * frame) - 1.0);
            const double distance = std::hypot(stand.eye.x, stand.eye.z);
            camera.eye = {distance * std::sin(angle), camera.eye.y, distance * std::cos(angle)};
            break;
        }
        case Way::still:
            break;
    }
    return camera;
}

Scene made(const Display& display, const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / display.file;
    std::error_code none;
    if (!std::filesystem::is_regular_file(file, none))
        throw std::runtime_error(
            fmt::format("mesh {}: no such file; the package glmark2-data has it", file.string()));
    const Mesh mesh = standing(load_mesh(file), display.up, 1.0);
    Scene scene{.mesh = make_parallelogram({-40, 0, 40}, {80, 0, 0}, {0, 0, -80}, 1.0),
                .ao_radius = display.radius};
    for (int row = 0; row < display.rows; ++row) {
        for (int copy = 0; copy < display.copies; ++copy) {
            const double x = display.spacing * (copy - 0.5 * (display.copies - 1));
            append(scene.mesh,
                   turned(mesh, upright_turn(0.9 * copy + 2.1 * row), {x, 0, -display.spacing * row}));
        }
    }
    return scene;
}

}  // namespace gloam::scene::views
