// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scene/views/generators.hpp"

namespace gloam::scene::views {
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

// A square slab around a vertical axis.
void add_slab(Parts& hall, double x, double z, double half_side, double low, double high) {
    hall.box({x - half_side, low, z - half_side}, {x + half_side, high, z + half_side});
}

// A column between plinth and capital, each of two slabs.
void add_column(Parts& hall, double x, double z) {
    constexpr double wide = 0.75;
    constexpr double narrow = 0.6;
    constexpr double step = foot_height / 2.0;
    add_slab(hall, x, z, wide, 0.0, step);
    add_slab(hall, x, z, narrow, step, foot_height);
    hall.cylinder({x, foot_height, z}, 0.45, hall_height - 2.0 * foot_height, 40);
    add_slab(hall, x, z, narrow, hall_height - foot_height, hall_height - step);
    add_slab(hall, x, z, wide, hall_height - step, hall_height);
}

// A box at the wall at x = side * half_width, from the floor up. depth: how far it stands out.
void add_at_wall(Parts& hall, double side, double depth, double height, double z_low, double z_high) {
    const double wall = side * half_width;
    const double face = side * (half_width - depth);
    hall.box({std::min(wall, face), 0, z_low}, {std::max(wall, face), height, z_high});
}

// The other parts of a bay: a beam under the ceiling, pilasters and benches at the walls.
void add_bay(Parts& hall, double z) {
    const double beam = hall_height - beam_height;
    hall.box({-half_width, beam, z - 0.3}, {half_width, hall_height, z + 0.3});
    for (const double side : {-1.0, 1.0}) {
        add_at_wall(hall, side, 0.3, beam, z - 0.4, z + 0.4);
        add_at_wall(hall, side, 0.6, 0.45, z - 4.0, z - 1.0);
    }
}

// The near end: a cable a hand's breadth in front of the eye, a parapet in front of the camera with a ball on
// it, and balls on the floor behind.
void add_foreground(Parts& hall) {
    hall.box({0.1, 0, 0.2}, {2.0, 1.5, 0.72});
    hall.cylinder({0.222, 0, 0.89}, 0.008, hall_height, 24);
    hall.sphere({0.75, 1.65, 0.4}, 0.15, 24, 48);
    hall.sphere({-1.2, 0.5, -5.0}, 0.5, 24, 48);
    hall.sphere({-2.1, 0.3, -5.4}, 0.3, 24, 48);
    hall.sphere({1.4, 0.7, -14.0}, 0.7, 24, 48);
}

}  // namespace

Scene make_columns(const Row& /*row*/) {
    Parts hall{.cell = 2.0};
    const glm::dvec3 across{2.0 * half_width, 0, 0};
    const glm::dvec3 up{0, hall_height, 0};
    const glm::dvec3 along{0, 0, front - back};
    const glm::dvec3 corner{-half_width, 0, back};
    // Floor, ceiling, side walls and the two ends.
    hall.add(make_parallelogram(corner, along, across, hall.cell));
    hall.add(make_parallelogram(corner + up, across, along, hall.cell));
    hall.add(make_parallelogram(corner, up, along, hall.cell));
    hall.add(make_parallelogram(corner + across, along, up, hall.cell));
    hall.add(make_parallelogram(corner, across, up, hall.cell));
    hall.add(make_parallelogram(corner + along, up, across, hall.cell));
    for (double z = 0.0; z > back; z -= bay) {
        add_bay(hall, z);
        add_column(hall, -column_x, z);
        add_column(hall, column_x, z);
    }
    add_foreground(hall);
    return {.mesh = std::move(hall.mesh), .lamp = glm::dvec3(-1.8, 4.6, -2.5)};
}

namespace {

// Metres. The room is x from -2 to 2, y from 0 to 2.6, z from -2.5 to 2.5.
constexpr double side = 2.0;
constexpr double end = 2.5;
constexpr double height = 2.6;

// Skirting boards, a cornice, floor boards with gaps of 4 mm.
void add_trim(Parts& room) {
    for (const double z : {-end, end - 0.02}) room.box({-side, 0, z}, {side, 0.09, z + 0.02});
    for (const double x : {-side, side - 0.02}) room.box({x, 0, -end}, {x + 0.02, 0.09, end});
    for (const double x : {-side, side - 0.06}) room.box({x, height - 0.06, -end}, {x + 0.06, height, end});
    room.box({-side, height - 0.06, -end}, {side, height, -end + 0.06});
    for (int i = 0; i < 25; ++i) {
        const double x = -side + 0.16 * i;
        room.box({x + 0.002, 0, -end}, {x + 0.158, 0.008, end});
    }
}

// A window in the end wall: a frame with bars before a niche's board.
void add_window(Parts& room) {
    constexpr double z = -end;
    room.box({0.4, 0.9, z}, {1.6, 0.94, z + 0.14});  // the sill
    for (const double x : {0.45, 0.99, 1.51}) room.box({x, 0.94, z}, {x + 0.04, 2.1, z + 0.05});
    for (const double y : {0.94, 1.5, 2.06}) room.box({0.45, y, z}, {1.55, y + 0.04, z + 0.05});
}

// Books of varying thickness and height on a board, from x = low to x = high.
void add_books(Parts& room, numeric::Random& random, double low, double high, double board, double z) {
    for (double x = low; x < high;) {
        const double thick = random.uniform(0.015, 0.05);
        const double tall = random.uniform(0.16, 0.27);
        const double deep = random.uniform(0.13, 0.2);
        if (random.unit() < 0.87) room.box({x, board, z}, {x + thick, board + tall, z + deep});
        x += thick + 0.001;
    }
}

// A shelf at the end wall.
void add_shelf(Parts& room) {
    numeric::Random random(2);
    constexpr double z = -end;
    for (const double x : {-1.7, -0.13}) room.box({x, 0.008, z}, {x + 0.03, 2.0, z + 0.26});
    for (int i = 0; i <= 5; ++i) {
        const double y = 0.06 + 0.38 * i;
        room.box({-1.67, y, z}, {-0.13, y + 0.025, z + 0.26});
        if (i < 5) add_books(room, random, -1.66, -0.2, y + 0.025, z + 0.02);
    }
}

// A table with a plate, cups and a ball on it, two stools.
void add_table(Parts& room) {
    room.box({-0.6, 0.72, -1.3}, {0.8, 0.76, -0.5});
    for (const double x : {-0.55, 0.7})
        for (const double z : {-1.25, -0.6}) room.box({x, 0.008, z}, {x + 0.05, 0.72, z + 0.05});
    room.cylinder({0.1, 0.76, -0.9}, 0.14, 0.012, 48);
    room.sphere({0.1, 0.81, -0.9}, 0.05, 24, 48);
    for (const double x : {-0.3, 0.45}) {
        room.cylinder({x, 0.76, -0.8}, 0.04, 0.1, 32);
        room.cylinder({x, 0.76, -0.8}, 0.036, 0.1, 32);  // its inside
    }
    for (const double x : {-1.1, 1.3}) {
        room.box({x - 0.18, 0.42, -1.1}, {x + 0.18, 0.46, -0.74});
        for (const double dx : {-0.16, 0.13})
            for (const double z : {-1.08, -0.79})
                room.box({x + dx, 0.008, z}, {x + dx + 0.03, 0.42, z + 0.03});
    }
}

}  // namespace

Scene make_room(const Row& /*row*/) {
    Parts room;
    room.add(inside_out(make_box({-side, 0, -end}, {side, height, end}, room.cell)));
    add_trim(room);
    add_window(room);
    add_shelf(room);
    add_table(room);
    return {.mesh = std::move(room.mesh), .lamp = glm::dvec3(-0.6, 2.1, 0.3)};
}

// A floor and two walls.
Scene make_corner(const Row& /*row*/) {
    constexpr double cell = 1.0;
    const glm::dvec3 x{12, 0, 0};
    const glm::dvec3 y{0, 12, 0};
    const glm::dvec3 z{0, 0, 12};
    Mesh mesh = colored(make_parallelogram({0, 0, 0}, z, x, cell), {0.8F, 0.8F, 0.8F});
    append(mesh, colored(make_parallelogram({0, 0, 0}, x, y, cell), {0.15F, 0.7F, 0.15F}));
    append(mesh, colored(make_parallelogram({0, 0, 0}, y, z, cell), {0.8F, 0.1F, 0.1F}));
    return {.mesh = std::move(mesh), .lamp = glm::dvec3(2.2, 3.4, 3.0)};
}

}  // namespace gloam::scene::views

namespace gloam::scene {
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

}  // namespace gloam::scene
