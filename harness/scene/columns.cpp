// SPDX-License-Identifier: MIT
#include "scene/internal/columns.hpp"
#include "scene/primitives.hpp"

namespace gloam::scene {
namespace {

constexpr double hall_length = 200.0;
constexpr double half_width = 5.0;
constexpr double hall_height = 6.0;
constexpr double spacing = 4.0;
constexpr double cell = 2.0;

// Base, shaft and capital.
Mesh make_column(double x, double z) {
    constexpr double plinth = 0.45;
    Mesh column = make_box({x - plinth, 0.0, z - plinth}, {x + plinth, 0.35, z + plinth}, cell);
    append(column, make_cylinder({x, 0.35, z}, 0.32, hall_height - 0.65, 32));
    append(column, make_box({x - plinth, hall_height - 0.3, z - plinth},
                            {x + plinth, hall_height, z + plinth}, cell));
    return column;
}

// Floor, ceiling and side walls of the hall, which runs from z = 2 to -hall_length.
Mesh make_hall() {
    const glm::dvec3 across{2.0 * half_width, 0, 0};
    const glm::dvec3 along{0, 0, -(hall_length + 2.0)};
    const glm::dvec3 up{0, hall_height, 0};
    Mesh hall = make_parallelogram({-half_width, 0, 2}, across, along, cell);
    append(hall, make_parallelogram({-half_width, hall_height, 2}, along, across, cell));
    append(hall, make_parallelogram({-half_width, 0, 2}, along, up, cell));
    append(hall, make_parallelogram({half_width, 0, 2}, up, along, cell));
    return hall;
}

}  // namespace

Scene make_columns() {
    Scene scene{.name = "columns", .mesh = make_hall()};
    for (double z = -1.2; z > -hall_length; z -= spacing) {
        append(scene.mesh, make_column(-2.2, z));
        append(scene.mesh, make_column(2.2, z));
    }
    append(scene.mesh, make_sphere({0.5, 0.4, -5.5}, 0.4, 24, 48));
    append(scene.mesh, make_box({-0.9, 0.0, -7.5}, {-0.2, 0.7, -6.8}, cell));
    append(scene.mesh, make_box({-0.75, 0.7, -7.4}, {-0.35, 1.1, -7.0}, cell));
    scene.camera = {.eye = {1.5, 1.6, 0.0},
                    .target = {0.0, 1.9, -10.0},
                    .fovy_rad = 1.0,
                    .near = 0.1,
                    .far = 250.0,
                    .reversed_z = true};
    scene.ao_radius = 0.6;
    return scene;
}

}  // namespace gloam::scene
