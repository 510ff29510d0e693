// SPDX-License-Identifier: MIT
#include <cmath>

#include "scene/views/generators.hpp"

namespace gloam::scene::views {
namespace {

constexpr double board = 0.03;

void add_box(Parts& parts, const glm::dvec3& center, const glm::dvec3& size) {
    parts.box(center - 0.5 * size, center + 0.5 * size);
}

// A table or a stool: a board on four legs.
Parts make_table(double width, double depth, double height) {
    Parts table;
    add_box(table, {0, height - 0.5 * board, 0}, {width, board, depth});
    for (const double x : {-0.5 * width + 0.04, 0.5 * width - 0.04})
        for (const double z : {-0.5 * depth + 0.04, 0.5 * depth - 0.04})
            add_box(table, {x, 0.5 * (height - board), z}, {0.05, height - board, 0.05});
    return table;
}

// A chair with a back of slats.
Parts make_chair() {
    Parts chair = make_table(0.44, 0.44, 0.46);
    for (const double x : {-0.19, 0.19}) add_box(chair, {x, 0.7, -0.2}, {0.04, 0.48, 0.03});
    for (int i = 0; i < 3; ++i) add_box(chair, {0, 0.6 + 0.14 * i, -0.2}, {0.36, 0.07, 0.02});
    return chair;
}

// A shelf of boards, three quarters full of books.
Parts make_shelf(numeric::Random& random, double width, double height) {
    constexpr double depth = 0.3;
    Parts shelf;
    for (const double x : {-0.5 * width, 0.5 * width})
        add_box(shelf, {x, 0.5 * height, 0}, {board, height, depth});
    add_box(shelf, {0, 0.5 * height, -0.5 * depth}, {width, height, 0.01});
    const Books books{{0.02, 0.18, 0.15}, {0.05, 0.29, 0.24}, 0.002, 0.75};
    for (double y = 0.05; y < height; y += 0.35) {
        add_box(shelf, {0, y, 0}, {width, board, depth});
        add_books(shelf, random, books, {-0.5 * width + 0.03, y + 0.5 * board, -0.5 * depth},
                  0.5 * width - 0.06);
    }
    return shelf;
}

// A lamp on a stand: a foot, a rod, a shade that is open above and below.
Parts make_lamp() {
    Parts lamp;
    lamp.add(make_rod({0, 0, 0}, {0, 0.03, 0}, 0.15, 24));
    lamp.add(make_rod({0, 0.03, 0}, {0, 1.4, 0}, 0.012, 8));
    lamp.add(make_cylinder({0, 1.3, 0}, 0.2, 0.25, 32));
    return lamp;
}

// A box on the floor, or at a height, turned and moved.
Mesh turned_box(double half_side, double low, double high, double turn, const glm::dvec3& at) {
    return placed(make_box({-half_side, low, -half_side}, {half_side, high, half_side}, 1.0),
                  upright_turn(turn), at);
}

// Crates of different sizes in a heap.
Parts make_crates(numeric::Random& random) {
    Parts crates;
    for (int i = 0; i < 3; ++i) {
        const double side = random.uniform(0.25, 0.45);
        const double turn = random.uniform(0.0, 1.5);
        crates.add(turned_box(0.5 * side, 0, side, turn, {0.5 * i - 0.5, 0, 0}));
    }
    crates.add(turned_box(0.15, 0.3, 0.55, 0.7, {-0.2, 0, 0}));
    return crates;
}

Parts make_furniture(numeric::Random& random) {
    switch (random.below(6)) {
        case 0:
            return make_table(random.uniform(0.8, 1.5), random.uniform(0.6, 0.9), 0.74);
        case 1:
            return make_table(0.36, 0.36, 0.45);
        case 2:
            return make_lamp();
        case 3:
            return make_crates(random);
        default:
            return make_chair();
    }
}

// Small things that stand on a board at a height.
void add_clutter(Parts& room, numeric::Random& random, const glm::dvec3& low, const glm::dvec3& high) {
    for (int i = 0; i < 14; ++i) {
        const glm::dvec3 at{random.uniform(low.x, high.x), low.y, random.uniform(low.z, high.z)};
        const double size = random.uniform(0.03, 0.09);
        if (i % 3 == 0)
            room.add(make_sphere(at + glm::dvec3(0, size, 0), size, 16));
        else if (i % 3 == 1)
            room.add(make_rod(at, at + glm::dvec3(0, 2.5 * size, 0), 0.6 * size, 24));
        else
            room.add(turned_box(size, 0, 0.8 * size, random.uniform(0.0, 1.5), at));
    }
}

// A pillar with a base and a capital.
void add_pillar(Parts& hall, const glm::dvec3& foot, double height) {
    hall.box(foot - glm::dvec3(0.4, 0, 0.4), foot + glm::dvec3(0.4, 0.3, 0.4));
    hall.add(make_cylinder(foot + glm::dvec3(0, 0.3, 0), 0.28, height - 0.6, 32));
    hall.box(foot + glm::dvec3(-0.4, height - 0.3, -0.4), foot + glm::dvec3(0.4, height, 0.4));
}

// A flight of steps up along -z.
void add_stairs(Parts& hall, const glm::dvec3& foot, double width, int steps) {
    for (int i = 0; i < steps; ++i) {
        const double z = foot.z - 0.3 * i;
        hall.box({foot.x - 0.5 * width, foot.y, z - 0.3}, {foot.x + 0.5 * width, foot.y + 0.17 * (i + 1), z});
    }
}

// A railing: posts and a rail.
void add_railing(Parts& hall, const glm::dvec3& from, const glm::dvec3& to, int posts) {
    hall.add(make_rod(from + glm::dvec3(0, 0.9, 0), to + glm::dvec3(0, 0.9, 0), 0.03, 12));
    for (int i = 0; i < posts; ++i) {
        const glm::dvec3 at = from + (to - from) * (static_cast<double>(i) / (posts - 1));
        hall.add(make_rod(at, at + glm::dvec3(0, 0.9, 0), 0.015, 8));
    }
}

// Niches in the wall x = side: blocks between them.
void add_niches(Parts& hall, double side, double length, double height) {
    const double inwards = side > 0.0 ? -0.5 : 0.5;
    for (double z = -length; z < 0.0; z += 2.4)
        hall.box({std::min(side, side + inwards), 0, z}, {std::max(side, side + inwards), height, z + 1.2});
}

// A toothed wheel that stands upright, its axis along z.
void add_gear(Parts& parts, const glm::dvec3& center, double radius, int teeth) {
    constexpr double thick = 0.08;
    parts.add(make_rod(center - glm::dvec3(0, 0, thick), center + glm::dvec3(0, 0, thick), radius, 48));
    parts.add(make_rod(center - glm::dvec3(0, 0, 0.3), center + glm::dvec3(0, 0, 0.2), 0.2 * radius, 24));
    const double tooth = 0.2 * full_turn * radius / teeth;
    for (int i = 0; i < teeth; ++i) {
        const double angle = full_turn * i / teeth;
        const glm::dvec3 out{std::cos(angle), std::sin(angle), 0};
        parts.add(make_rod(center + 0.95 * radius * out, center + (radius + 2.0 * tooth) * out, tooth, 6));
    }
}

// A pipe through corners, with a flange at each.
void add_pipe(Parts& parts, const std::vector<glm::dvec3>& corners, double radius) {
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        parts.add(make_rod(corners[i], corners[i + 1], radius, 20));
        parts.add(make_sphere(corners[i + 1], 1.05 * radius, 12));
        const glm::dvec3 way = glm::normalize(corners[i + 1] - corners[i]);
        const glm::dvec3 middle = 0.5 * (corners[i] + corners[i + 1]);
        parts.add(make_rod(middle - 0.04 * way, middle + 0.04 * way, 1.4 * radius, 20));
    }
}

// A housing with fins, bolts and a dial.
void add_housing(Parts& parts, numeric::Random& random, const glm::dvec3& low, const glm::dvec3& size) {
    parts.box(low, low + size);
    for (double x = 0.1; x < size.x - 0.1; x += 0.12)
        parts.box(low + glm::dvec3(x, size.y, 0.1), low + glm::dvec3(x + 0.03, size.y + 0.12, size.z - 0.1));
    for (const double x : {0.08, size.x - 0.08})
        for (const double y : {0.08, size.y - 0.08})
            parts.add(
                make_rod(low + glm::dvec3(x, y, size.z), low + glm::dvec3(x, y, size.z + 0.04), 0.04, 6));
    const double dial = random.uniform(0.1, 0.2);
    const glm::dvec3 middle = low + glm::dvec3(0.5 * size.x, 0.5 * size.y, size.z);
    parts.add(make_rod(middle, middle + glm::dvec3(0, 0, 0.08), dial, 32));
}

}  // namespace

Scene make_interior(const Row& row) {
    numeric::Random random = random_of(row);
    const double w = row.value("half_width", 2.5);
    const double d = row.value("half_depth", 2.5);
    const bool roofed = row.value("roofed", true);
    Parts room;
    if (roofed) {
        room.add(inside_out(make_box({-w, 0, -d}, {w, 2.6, d}, room.cell)));
    } else {
        room.box({-w, -0.1, -d}, {w, 0, d});
        add_box(room, {0, 1.3, -d}, {2 * w, 2.6, 0.1});
    }
    for (double x = -w + 0.7; x < w - 0.6; x += 1.25)
        room.add(
            placed(make_shelf(random, 1.1, random.uniform(1.3, 2.1)).mesh, glm::dmat3(1), {x, 0, -d + 0.21}));
    for (double x = -w + 0.7; x < w - 0.5; x += 1.3) {
        for (double z = -d + 1.1; z < d - 0.5; z += 1.3) {
            if (random.unit() > row.value("fullness", 0.6)) continue;
            const double turn = random.uniform(0.0, full_turn);
            const double dx = random.uniform(-0.15, 0.15);
            room.add(placed(make_furniture(random).mesh, upright_turn(turn), {x + dx, 0, z}));
        }
    }
    room.add(make_table(1.4, 0.8, 0.74).mesh);
    add_clutter(room, random, {-0.6, 0.74, -0.3}, {0.6, 0.74, 0.3});
    Scene scene{.mesh = std::move(room.mesh)};
    if (roofed) scene.lamp = glm::dvec3(0.3, 2.2, 0.4);
    return scene;
}

Scene make_hall(const Row& row) {
    const double w = row.value("half_width", 4.0);
    const double length = row.value("length", 14.0);
    const double height = row.value("height", 4.5);
    const double pillars = row.value("pillars", 2.2);
    Parts parts{.cell = 2.0};
    parts.add(inside_out(make_box({-w, 0, -length}, {w, height, 2.0}, parts.cell)));
    for (const double side : {-w, w}) add_niches(parts, side, length, height);
    for (double z = -length + 1.2; z < 1.0; z += 2.4) {
        parts.box({-w, height - 0.4, z - 0.2}, {w, height, z + 0.2});
        for (const double x : {-pillars, pillars}) add_pillar(parts, {x, 0, z}, height - 0.4);
    }
    add_stairs(parts, {0, 0, -0.5 * length}, 1.6, 9);
    for (const double x : {-0.85, 0.85})
        add_railing(parts, {x, 0.1, -0.5 * length}, {x, 1.6, -0.5 * length - 2.7}, 10);
    numeric::Random random = random_of(row);
    for (int i = 0; i < 12; ++i) {
        const double radius = random.uniform(0.1, 0.35);
        const glm::dvec3 center{random.uniform(-w + 0.9, w - 0.9), radius,
                                random.uniform(-length + 1.0, -0.5)};
        parts.add(make_sphere(center, radius, 24));
    }
    return {.mesh = std::move(parts.mesh), .lamp = glm::dvec3(0.2, height - 0.8, -1.5)};
}

Scene make_machine(const Row& row) {
    numeric::Random random = random_of(row);
    const int count = row.value("parts", 5);
    const int pipes = row.value("pipes", 6);
    Parts parts{.cell = 0.5, .mesh = make_parallelogram({-20, 0, -20}, {0, 0, 40}, {40, 0, 0}, 1.0)};
    parts.add(make_box({-6, 0, -2.2}, {6, 5, -2.0}, 1.0));
    for (int i = 0; i < count; ++i) {
        const double x = -2.4 + 4.8 * (i + 0.5) / count;
        const double tall = random.uniform(0.5, 1.3);
        add_housing(parts, random, {x - 0.35, 0, -1.2},
                    {random.uniform(0.5, 0.75), tall, random.uniform(0.5, 0.9)});
        const double radius = random.uniform(0.2, 0.4);
        const int teeth = 10 + static_cast<int>(random.below(8));
        add_gear(parts, {x + random.uniform(-0.1, 0.1), 0.5 + tall + random.uniform(-0.05, 0.05), -1.5},
                 radius, teeth);
    }
    for (int i = 0; i < pipes; ++i) {
        const double y = 0.3 + 2.0 * (i + 0.5) / pipes;
        const double z = random.uniform(-1.9, -0.4);
        const double turn = random.uniform(-1.5, 1.5);
        add_pipe(parts, {{-4, y, z}, {turn, y, z}, {turn, y, z + 0.6}, {turn, 0, z + 0.6}},
                 random.uniform(0.04, 0.1));
    }
    return {.mesh = std::move(parts.mesh)};
}

}  // namespace gloam::scene::views
