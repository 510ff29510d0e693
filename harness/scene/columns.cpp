// SPDX-License-Identifier: MIT
#include "scene/internal/built_in_scenes.hpp"

#include <algorithm>
#include <cmath>

#include "scene/primitives.hpp"

namespace gloam::scene {
namespace {

// World units are metres. The hall runs along -z from behind the camera.
constexpr double half_width = 7.0;
constexpr double hall_height = 6.0;
constexpr double front = 3.0;
constexpr double back = -200.0;
constexpr double bay = 5.0;          // from column to column
constexpr double column_x = 3.5;     // of the two rows
constexpr double foot_height = 0.5;  // of plinths; capitals are as high
constexpr double beam_height = 0.25;
constexpr double columns_cell = 2.0;

// Floor, ceiling, side walls and the two ends.
Mesh make_columns_shell() {
    const glm::dvec3 across{2.0 * half_width, 0, 0};
    const glm::dvec3 up{0, hall_height, 0};
    const glm::dvec3 along{0, 0, front - back};
    const glm::dvec3 corner{-half_width, 0, back};
    Mesh shell = make_parallelogram(corner, along, across, columns_cell);
    append(shell, make_parallelogram(corner + up, across, along, columns_cell));
    append(shell, make_parallelogram(corner, up, along, columns_cell));
    append(shell, make_parallelogram(corner + across, along, up, columns_cell));
    append(shell, make_parallelogram(corner, across, up, columns_cell));
    append(shell, make_parallelogram(corner + along, up, across, columns_cell));
    return shell;
}

// A square slab around a vertical axis.
Mesh make_slab(double x, double z, double half_side, double low, double high) {
    return make_box({x - half_side, low, z - half_side}, {x + half_side, high, z + half_side}, columns_cell);
}

// A column between plinth and capital, each of two slabs.
Mesh make_column(double x, double z) {
    constexpr double wide = 0.75;
    constexpr double narrow = 0.6;
    constexpr double step = foot_height / 2.0;
    Mesh column = make_slab(x, z, wide, 0.0, step);
    append(column, make_slab(x, z, narrow, step, foot_height));
    append(column, make_cylinder({x, foot_height, z}, 0.45, hall_height - 2.0 * foot_height, 40));
    append(column, make_slab(x, z, narrow, hall_height - foot_height, hall_height - step));
    append(column, make_slab(x, z, wide, hall_height - step, hall_height));
    return column;
}

// A box at the wall at x = side * half_width, from the floor up. depth: how far it stands out.
Mesh make_at_wall(double side, double depth, double height, double z_low, double z_high) {
    const double wall = side * half_width;
    const double face = side * (half_width - depth);
    return make_box({std::min(wall, face), 0, z_low}, {std::max(wall, face), height, z_high}, columns_cell);
}

// The other parts of a bay: a beam under the ceiling, pilasters and benches at the walls.
Mesh make_bay(double z) {
    const double beam = hall_height - beam_height;
    Mesh mesh = make_box({-half_width, beam, z - 0.3}, {half_width, hall_height, z + 0.3}, columns_cell);
    for (const double side : {-1.0, 1.0}) {
        append(mesh, make_at_wall(side, 0.3, beam, z - 0.4, z + 0.4));
        append(mesh, make_at_wall(side, 0.6, 0.45, z - 4.0, z - 1.0));
    }
    return mesh;
}

// The near end: a cable a hand's breadth in front of the eye, a parapet in front of the camera with a ball on
// it, and balls on the floor behind.
Mesh make_foreground() {
    Mesh mesh = make_box({0.1, 0, 0.2}, {2.0, 1.5, 0.72}, columns_cell);
    append(mesh, make_cylinder({0.222, 0, 0.89}, 0.008, hall_height, 24));
    append(mesh, make_sphere({0.75, 1.65, 0.4}, 0.15, 24, 48));
    append(mesh, make_sphere({-1.2, 0.5, -5.0}, 0.5, 24, 48));
    append(mesh, make_sphere({-2.1, 0.3, -5.4}, 0.3, 24, 48));
    append(mesh, make_sphere({1.4, 0.7, -14.0}, 0.7, 24, 48));
    return mesh;
}

}  // namespace

Scene make_columns() {
    Scene scene{.name = "columns", .mesh = make_columns_shell()};
    for (double z = 0.0; z > back; z -= bay) {
        append(scene.mesh, make_bay(z));
        append(scene.mesh, make_column(-column_x, z));
        append(scene.mesh, make_column(column_x, z));
    }
    append(scene.mesh, make_foreground());
    scene.camera = {.eye = {0.3, 1.75, 1.0},
                    .target = {0.0, 1.9, -12.0},
                    .fovy_rad = 1.0,
                    .near = 0.05,
                    .far = 250.0,
                    .reversed_z = true};
    // The camera sways from side to side, so that near objects move in front of distant ones.
    scene.camera_path = [start = scene.camera](int frame) {
        Camera camera = start;
        camera.eye += glm::dvec3(0.12 * std::sin(0.05 * frame), 0.02 * std::sin(0.11 * frame), 0.0);
        return camera;
    };
    scene.ao_radius = 0.5;
    scene.lamp = glm::dvec3(-1.8, 4.6, -2.5);
    return scene;
}

}  // namespace gloam::scene
