// SPDX-License-Identifier: MIT
#include "scene/internal/built_in_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "numeric/random.hpp"
#include "scene/mesh.hpp"

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

namespace {

// Integral of (1 - c / cos t)^2 over t from -arccos(c) to `end`, for a wall at c = a / R; 0 beyond the
// radius.
double wall_integral(double c, double end) {
    if (c >= 1.0) return 0.0;
    const auto antiderivative = [c](double t) {
        const double tangent = std::tan(t);
        return t - 2.0 * c * std::asinh(tangent) + c * c * tangent;
    };
    const double reach = std::acos(c);
    return antiderivative(std::clamp(end, -reach, reach)) - antiderivative(-reach);
}

}  // namespace

double corner_occlusion(double a, double b, double radius) {
    // The azimuth of the corner's edge, where the nearer wall changes; measured from the first wall's normal.
    const double edge = std::atan2(b, a);
    const double sum =
        wall_integral(a / radius, edge) + wall_integral(b / radius, 0.5 * std::numbers::pi - edge);
    return sum / (2.0 * std::numbers::pi);
}

double corner_occlusion_at(const glm::dvec3& world, double radius) {
    std::array distances{std::abs(world.x), std::abs(world.y), std::abs(world.z)};
    std::ranges::sort(distances);
    return corner_occlusion(distances[1], distances[2], radius);
}

Scene make_corner() {
    constexpr double extent = 12.0;
    constexpr double cell = 1.0;
    const glm::dvec3 x{extent, 0, 0};
    const glm::dvec3 y{0, extent, 0};
    const glm::dvec3 z{0, 0, extent};
    Scene scene{.name = "corner",
                .mesh = colored(make_parallelogram({0, 0, 0}, z, x, cell), {0.8F, 0.8F, 0.8F})};
    append(scene.mesh, colored(make_parallelogram({0, 0, 0}, x, y, cell), {0.15F, 0.7F, 0.15F}));
    append(scene.mesh, colored(make_parallelogram({0, 0, 0}, y, z, cell), {0.8F, 0.1F, 0.1F}));
    scene.camera = {.eye = {3.6, 3.1, 3.9},
                    .target = {0.6, 0.6, 0.6},
                    .fovy_rad = 0.9,
                    .near = 0.1,
                    .far = 40.0,
                    .reversed_z = true};
    scene.ao_radius = 1.0;
    scene.lamp = glm::dvec3(2.2, 3.4, 3.0);
    return scene;
}

}  // namespace gloam::scene
