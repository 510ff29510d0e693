// SPDX-License-Identifier: MIT
#include <cmath>

#include "numeric/random.hpp"
#include "scene/internal/built_in_scenes.hpp"
#include "scene/primitives.hpp"

namespace gloam::scene {
namespace {

// Metres. The room is x from -2 to 2, y from 0 to 2.6, z from -2.5 to 2.5.
constexpr double side = 2.0;
constexpr double end = 2.5;
constexpr double height = 2.6;
constexpr double room_cell = 1.0;

// A box whose faces look inwards.
Mesh make_room_shell() {
    Mesh shell = make_box({-side, 0, -end}, {side, height, end}, room_cell);
    for (std::size_t i = 0; i < shell.indices.size(); i += 3)
        std::swap(shell.indices[i + 1], shell.indices[i + 2]);
    for (glm::vec3& normal : shell.normals) normal = -normal;
    return shell;
}

// Skirting boards, a cornice, floor boards with gaps of 4 mm.
Mesh make_trim() {
    Mesh mesh;
    for (const double z : {-end, end - 0.02})
        append(mesh, make_box({-side, 0, z}, {side, 0.09, z + 0.02}, room_cell));
    for (const double x : {-side, side - 0.02})
        append(mesh, make_box({x, 0, -end}, {x + 0.02, 0.09, end}, room_cell));
    for (const double x : {-side, side - 0.06})
        append(mesh, make_box({x, height - 0.06, -end}, {x + 0.06, height, end}, room_cell));
    append(mesh, make_box({-side, height - 0.06, -end}, {side, height, -end + 0.06}, room_cell));
    for (int i = 0; i < 25; ++i) {
        const double x = -side + 0.16 * i;
        append(mesh, make_box({x + 0.002, 0, -end}, {x + 0.158, 0.008, end}, room_cell));
    }
    return mesh;
}

// A window in the end wall: a frame with bars before a niche's board.
Mesh make_window() {
    constexpr double z = -end;
    Mesh mesh = make_box({0.4, 0.9, z}, {1.6, 0.94, z + 0.14}, room_cell);  // the sill
    for (const double x : {0.45, 0.99, 1.51})
        append(mesh, make_box({x, 0.94, z}, {x + 0.04, 2.1, z + 0.05}, room_cell));
    for (const double y : {0.94, 1.5, 2.06})
        append(mesh, make_box({0.45, y, z}, {1.55, y + 0.04, z + 0.05}, room_cell));
    return mesh;
}

// Books of varying thickness and height on a board, from x = low to x = high.
void add_books(Mesh& mesh, numeric::Random& random, double low, double high, double board, double z) {
    for (double x = low; x < high;) {
        const double thick = random.uniform(0.015, 0.05);
        const double tall = random.uniform(0.16, 0.27);
        const double deep = random.uniform(0.13, 0.2);
        if (random.unit() < 0.87)
            append(mesh, make_box({x, board, z}, {x + thick, board + tall, z + deep}, room_cell));
        x += thick + 0.001;
    }
}

// A shelf at the end wall.
Mesh make_shelf() {
    numeric::Random random(2);
    constexpr double z = -end;
    Mesh mesh;
    for (const double x : {-1.7, -0.13})
        append(mesh, make_box({x, 0.008, z}, {x + 0.03, 2.0, z + 0.26}, room_cell));
    for (int i = 0; i <= 5; ++i) {
        const double y = 0.06 + 0.38 * i;
        append(mesh, make_box({-1.67, y, z}, {-0.13, y + 0.025, z + 0.26}, room_cell));
        if (i < 5) add_books(mesh, random, -1.66, -0.2, y + 0.025, z + 0.02);
    }
    return mesh;
}

// A table with a plate, cups and a ball on it, two stools.
Mesh make_table() {
    Mesh mesh = make_box({-0.6, 0.72, -1.3}, {0.8, 0.76, -0.5}, room_cell);
    for (const double x : {-0.55, 0.7})
        for (const double z : {-1.25, -0.6})
            append(mesh, make_box({x, 0.008, z}, {x + 0.05, 0.72, z + 0.05}, room_cell));
    append(mesh, make_cylinder({0.1, 0.76, -0.9}, 0.14, 0.012, 48));
    append(mesh, make_sphere({0.1, 0.81, -0.9}, 0.05, 24, 48));
    for (const double x : {-0.3, 0.45}) {
        append(mesh, make_cylinder({x, 0.76, -0.8}, 0.04, 0.1, 32));
        append(mesh, make_cylinder({x, 0.76, -0.8}, 0.036, 0.1, 32));  // its inside
    }
    for (const double x : {-1.1, 1.3}) {
        append(mesh, make_box({x - 0.18, 0.42, -1.1}, {x + 0.18, 0.46, -0.74}, room_cell));
        for (const double dx : {-0.16, 0.13})
            for (const double z : {-1.08, -0.79})
                append(mesh, make_box({x + dx, 0.008, z}, {x + dx + 0.03, 0.42, z + 0.03}, room_cell));
    }
    return mesh;
}

}  // namespace

Scene make_room() {
    Scene scene{.name = "room", .mesh = make_room_shell()};
    for (const Mesh& part : {make_trim(), make_window(), make_shelf(), make_table()})
        append(scene.mesh, part);
    scene.camera = {.eye = {0.7, 1.5, 1.6},
                    .target = {-0.2, 0.8, -1.6},
                    .fovy_rad = 0.95,
                    .near = 0.05,
                    .far = 20.0,
                    .reversed_z = true};
    scene.camera_path = [start = scene.camera](int frame) {
        Camera camera = start;
        camera.eye += glm::dvec3(0.5 * std::sin(0.02 * frame), 0.0, -0.3 * std::sin(0.015 * frame));
        return camera;
    };
    scene.ao_radius = 0.3;
    scene.lamp = glm::dvec3(-0.6, 2.1, 0.3);
    return scene;
}

}  // namespace gloam::scene
