// SPDX-License-Identifier: MIT
#include <cmath>

#include "numeric/random.hpp"
#include "scene/primitives.hpp"
#include "scene/views/camera_paths.hpp"
#include "scene/views/generators.hpp"
#include "scene/views/shapes.hpp"

namespace gloam::scene::views {
namespace {

constexpr double furniture_cell = 1.0;  // of the faces of boxes, metres
constexpr double board = 0.03;

void add_box(Mesh& mesh, const glm::dvec3& center, const glm::dvec3& size) {
    append(mesh, make_box(center - 0.5 * size, center + 0.5 * size, furniture_cell));
}

// A table or a stool: a board on four legs.
Mesh make_table(double width, double depth, double height) {
    Mesh mesh;
    add_box(mesh, {0, height - 0.5 * board, 0}, {width, board, depth});
    for (const double x : {-0.5 * width + 0.04, 0.5 * width - 0.04})
        for (const double z : {-0.5 * depth + 0.04, 0.5 * depth - 0.04})
            add_box(mesh, {x, 0.5 * (height - board), z}, {0.05, height - board, 0.05});
    return mesh;
}

// A chair with a back of slats.
Mesh make_chair() {
    Mesh mesh = make_table(0.44, 0.44, 0.46);
    for (const double x : {-0.19, 0.19}) add_box(mesh, {x, 0.7, -0.2}, {0.04, 0.48, 0.03});
    for (int i = 0; i < 3; ++i) add_box(mesh, {0, 0.6 + 0.14 * i, -0.2}, {0.36, 0.07, 0.02});
    return mesh;
}

// A shelf of boards, three quarters full of books.
Mesh make_shelf(numeric::Random& random, double width, double height) {
    constexpr double depth = 0.3;
    Mesh mesh;
    for (const double x : {-0.5 * width, 0.5 * width})
        add_box(mesh, {x, 0.5 * height, 0}, {board, height, depth});
    add_box(mesh, {0, 0.5 * height, -0.5 * depth}, {width, height, 0.01});
    for (double y = 0.05; y < height; y += 0.35) {
        add_box(mesh, {0, y, 0}, {width, board, depth});
        for (double x = -0.5 * width + 0.03; x < 0.5 * width - 0.06;) {
            const double thick = random.uniform(0.02, 0.05);
            const double tall = random.uniform(0.18, 0.29);
            const double deep = random.uniform(0.15, 0.24);
            if (random.unit() < 0.75)
                add_box(mesh, {x + 0.5 * thick, y + 0.5 * (board + tall), -0.5 * (depth - deep)},
                        {thick, tall, deep});
            x += thick + 0.002;
        }
    }
    return mesh;
}

// A lamp on a stand: a foot, a rod, a shade that is open above and below.
Mesh make_lamp() {
    Mesh mesh = make_rod({0, 0, 0}, {0, 0.03, 0}, 0.15, 24);
    append(mesh, make_rod({0, 0.03, 0}, {0, 1.4, 0}, 0.012, 8));
    append(mesh, make_cylinder({0, 1.3, 0}, 0.2, 0.25, 32));
    return mesh;
}

// Crates of different sizes in a heap.
Mesh make_crates(numeric::Random& random) {
    Mesh mesh;
    for (int i = 0; i < 3; ++i) {
        const double side = random.uniform(0.25, 0.45);
        const double turn = random.uniform(0.0, 1.5);
        append(mesh,
               turned(make_box({-0.5 * side, 0, -0.5 * side}, {0.5 * side, side, 0.5 * side}, furniture_cell),
                      turn, {0.5 * i - 0.5, 0, 0}));
    }
    append(mesh,
           turned(make_box({-0.15, 0.3, -0.15}, {0.15, 0.55, 0.15}, furniture_cell), 0.7, {-0.2, 0, 0}));
    return mesh;
}

Mesh make_furniture(numeric::Random& random) {
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
void add_clutter(Mesh& mesh, numeric::Random& random, const glm::dvec3& low, const glm::dvec3& high) {
    for (int i = 0; i < 14; ++i) {
        const glm::dvec3 at{random.uniform(low.x, high.x), low.y, random.uniform(low.z, high.z)};
        const double size = random.uniform(0.03, 0.09);
        if (i % 3 == 0)
            append(mesh, make_sphere(at + glm::dvec3(0, size, 0), size, 16, 32));
        else if (i % 3 == 1)
            append(mesh, make_rod(at, at + glm::dvec3(0, 2.5 * size, 0), 0.6 * size, 24));
        else
            append(mesh, turned(make_box({-size, 0, -size}, {size, 0.8 * size, size}, furniture_cell),
                                random.uniform(0.0, 1.5), at));
    }
}

}  // namespace

Scene make_furnished(const Interior& interior) {
    numeric::Random random(interior.seed);
    const double w = interior.half_width;
    const double d = interior.half_depth;
    const double top = interior.roofed ? 2.6 : 6.0;
    Scene scene{.mesh = inside_out(make_box({-w, 0, -d}, {w, top, d}, furniture_cell))};
    if (!interior.roofed) scene.mesh = make_box({-w, -0.1, -d}, {w, 0, d}, furniture_cell);
    if (!interior.roofed) add_box(scene.mesh, {0, 1.3, -d}, {2 * w, 2.6, 0.1});
    for (double x = -w + 0.7; x < w - 0.6; x += 1.25)
        append(scene.mesh, turned(make_shelf(random, 1.1, random.uniform(1.3, 2.1)), 0.0, {x, 0, -d + 0.21}));
    for (double x = -w + 0.7; x < w - 0.5; x += 1.3) {
        for (double z = -d + 1.1; z < d - 0.5; z += 1.3) {
            if (random.unit() > interior.fullness) continue;
            const double turn = random.uniform(0.0, full_turn);
            const double dx = random.uniform(-0.15, 0.15);
            append(scene.mesh, turned(make_furniture(random), turn, {x + dx, 0, z}));
        }
    }
    append(scene.mesh, turned(make_table(1.4, 0.8, 0.74), 0.0, {0, 0, 0}));
    add_clutter(scene.mesh, random, {-0.6, 0.74, -0.3}, {0.6, 0.74, 0.3});
    scene.ao_radius = interior.radius;
    if (interior.roofed) scene.lamp = glm::dvec3(0.3, 2.2, 0.4);
    return scene;
}

}  // namespace gloam::scene::views
