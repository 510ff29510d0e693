// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "scene/views/generators.hpp"

namespace gloam::scene::views {
namespace {

// A unit vector; every direction is equally likely.
glm::dvec3 any_direction(numeric::Random& random) {
    const double y = random.uniform(-1.0, 1.0);
    const double around = random.uniform(0.0, full_turn);
    const double out = std::sqrt(1.0 - y * y);
    return {out * std::cos(around), y, out * std::sin(around)};
}

// A flat leaf or blade without thickness that grows from `at` in a number of steps. half, way: at each part
// of its length (0 to 1) half its width, and the step to the next one. Its smooth normals are towards the
// side of half x way.
Mesh make_leaf(glm::dvec3 at, int steps, const std::function<glm::dvec3(double)>& half,
               const std::function<glm::dvec3(double)>& way) {
    std::vector<glm::dvec3> left;
    std::vector<glm::dvec3> right;
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        left.push_back(at - half(t));
        right.push_back(at + half(t));
        at += way(t);
    }
    return make_grid(1, steps, [&](int x, int y) -> Vertex {
        const auto row = static_cast<std::size_t>(y);
        const std::size_t before = row == 0 ? 0 : row - 1;
        const std::size_t after = std::min(row + 1, left.size() - 1);
        const glm::dvec3 along = left[after] + right[after] - left[before] - right[before];
        // The tip can be a point; then the width of the previous row gives the direction.
        glm::dvec3 across = right[row] - left[row];
        if (!(glm::length(across) > 0.0)) across = right[before] - left[before];
        return {x == 0 ? left[row] : right[row], glm::normalize(glm::cross(across, along))};
    });
}

// A leaf that grows in a direction and droops.
Mesh make_leaf(numeric::Random& random, const glm::dvec3& foot, glm::dvec3 ahead, double length,
               double width) {
    const glm::dvec3 side = glm::normalize(glm::cross(ahead, any_direction(random)));
    constexpr int steps = 4;
    return make_leaf(
        foot, steps,
        [&](double t) { return 0.5 * width * std::sin(std::numbers::pi * (0.1 + 0.85 * t)) * side; },
        [&](double) {
            const glm::dvec3 step = length / steps * ahead;
            ahead = glm::normalize(ahead - glm::dvec3(0, 0.15, 0));
            return step;
        });
}

// Leaves in a ball, denser near its surface, as of a bush or a crown.
void add_crown(Parts& parts, numeric::Random& random, const glm::dvec3& center, double radius, int leaves,
               double leaf) {
    for (int i = 0; i < leaves; ++i) {
        const glm::dvec3 out = any_direction(random);
        const double far = radius * std::sqrt(random.uniform(0.15, 1.0));
        parts.add(make_leaf(random, center + far * out, out, random.uniform(0.7, 1.3) * leaf, 0.5 * leaf));
    }
}

void add_tree(Parts& parts, numeric::Random& random, const glm::dvec3& foot, int leaves, double leaf) {
    const double height = random.uniform(0.8, 1.2) * 1.6;
    const glm::dvec3 top = foot + glm::dvec3(0.05 * height, height, 0.03 * height);
    parts.add(make_rod(foot, top, 0.06 * height, 12));
    for (int i = 0; i < 6; ++i) {
        const glm::dvec3 from = foot + random.uniform(0.5, 0.95) * (top - foot);
        const glm::dvec3 aside = any_direction(random) * glm::dvec3(1, 0.3, 1);
        const glm::dvec3 to = from + height * (0.25 * aside + glm::dvec3(0, 0.2, 0));
        parts.add(make_rod(from, to, 0.015 * height, 8));
        add_crown(parts, random, to, 0.25 * height, leaves / 8, leaf);
    }
    add_crown(parts, random, top + glm::dvec3(0, 0.15 * height, 0), 0.35 * height, leaves / 4, leaf);
}

// The shape of a blade or a leaf that leans towards the azimuth `heading`.
struct Blade {
    double heading;
    double length;
    double width;   // at its widest, metres
    double lean;    // angle from upright at the foot, radians
    double bend;    // additional lean at the tip
    double widest;  // position of the widest part, 0 to 1
};

Mesh make_blade(const glm::dvec3& foot, const Blade& blade) {
    const glm::dvec3 ahead{std::sin(blade.heading), 0, std::cos(blade.heading)};
    const glm::dvec3 across{std::cos(blade.heading), 0, -std::sin(blade.heading)};
    constexpr int steps = 5;
    return make_leaf(
        foot, steps,
        [&](double t) {
            const double part =
                t < blade.widest ? 0.3 + 0.7 * t / blade.widest : (1.0 - t) / (1.0 - blade.widest);
            return 0.5 * (blade.width * part) * across;
        },
        [&](double t) {
            const double lean = blade.lean + blade.bend * t;
            return blade.length / steps * (std::cos(lean) * glm::dvec3(0, 1, 0) + std::sin(lean) * ahead);
        });
}

// A random value in [-1, 1] for whole coordinates.
double lattice_value(double x, double z, std::uint64_t seed) {
    const auto column = static_cast<std::uint64_t>(static_cast<std::int64_t>(x) + 4096);
    const auto row = static_cast<std::uint64_t>(static_cast<std::int64_t>(z) + 4096);
    std::uint64_t bits = seed + column * 0x9e3779b97f4a7c15U + row * 0xc2b2ae3d27d4eb4fU;
    bits = (bits ^ bits >> 29) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ bits >> 32) * 0x94d049bb133111ebU;
    return static_cast<double>(bits >> 11) * 0x1p-52 - 1.0;
}

double eased(double t) {
    return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

// Smooth noise in [-1, 1] with the features of size 1, from random values at whole coordinates.
double smooth_noise(double x, double z, std::uint64_t seed) {
    const double column = std::floor(x);
    const double row = std::floor(z);
    const double u = eased(x - column);
    const double v = eased(z - row);
    const double near = std::lerp(lattice_value(column, row, seed), lattice_value(column + 1, row, seed), u);
    const double far =
        std::lerp(lattice_value(column, row + 1, seed), lattice_value(column + 1, row + 1, seed), u);
    return std::lerp(near, far, v);
}

// Sum of `octaves` smooth noises, each of half the size and half the height of the one before.
double fractal_noise(double x, double z, int octaves, std::uint64_t seed) {
    double sum = 0.0;
    double scale = 1.0;
    for (int i = 0; i < octaves; ++i, scale *= 2.0)
        sum += smooth_noise(scale * x, scale * z, seed + static_cast<std::uint64_t>(i)) / scale;
    return sum;
}

// A stone: a sphere whose radius varies smoothly.
Mesh make_stone(const glm::dvec3& center, double radius, std::uint64_t seed) {
    Mesh mesh = make_sphere({0, 0, 0}, 1.0, 20);
    for (glm::vec3& p : mesh.positions) {
        const double rough = fractal_noise(1.5 * p.x + 7.0 + p.y, 1.5 * p.z + 7.0 - p.y, 3, seed);
        p = center + radius * (1.0 + 0.3 * rough) * glm::dvec3(p);
    }
    return mesh;
}

// A square height field: x and z from -half to half, with cells x cells cells, smooth normals.
Mesh make_height_field(double half, int cells, const std::function<double(double x, double z)>& height) {
    const double step = 2.0 * half / cells;
    Mesh mesh = make_grid(cells, cells, [&](int column, int row) -> Vertex {
        const double x = -half + column * step;
        const double z = -half + row * step;
        const double dx = height(x + step, z) - height(x - step, z);
        const double dz = height(x, z + step) - height(x, z - step);
        return {{x, height(x, z), z}, glm::normalize(glm::dvec3(-dx, 2.0 * step, -dz))};
    });
    // The field is seen from the other side, and its cells are divided along the other diagonal.
    for (auto corner = mesh.indices.begin(); corner != mesh.indices.end(); corner += 6) {
        const std::uint32_t at = corner[0];
        const std::uint32_t below = corner[5];
        std::ranges::copy(std::array{at, below, at + 1, at + 1, below, below + 1}, corner);
    }
    return mesh;
}

}  // namespace

Scene make_foliage(const Row& row) {
    numeric::Random random = random_of(row);
    const double half = row.value("half_side", 3.0);
    const int leaves = row.value("leaves", 400);
    const double leaf = row.value("leaf", 0.12);
    const double blade = row.value("blade", 0.2);
    Parts parts{.mesh = make_parallelogram({-30, 0, -30}, {0, 0, 60}, {60, 0, 0}, 2.0)};
    const auto anywhere = [&](double y = 0.0) {
        return glm::dvec3{random.uniform(-half, half), y, random.uniform(-half, half)};
    };
    for (int i = 0; i < row.value("trees", 0); ++i) add_tree(parts, random, anywhere(), leaves, leaf);
    for (int i = 0; i < row.value("bushes", 0); ++i) {
        const double radius = random.uniform(0.25, 0.45);
        add_crown(parts, random, anywhere(0.8 * radius), radius, leaves, leaf);
    }
    for (int i = 0; i < row.value("blades", 0); ++i) {
        const glm::dvec3 foot = anywhere();
        const double around = random.uniform(0.0, full_turn);
        const glm::dvec3 up = glm::normalize(glm::dvec3(0.4 * std::cos(around), 1.0, 0.4 * std::sin(around)));
        parts.add(make_leaf(random, foot, up, random.uniform(0.6, 1.4) * blade, 0.08 * blade));
    }
    return {.mesh = std::move(parts.mesh)};
}

Scene make_grass(const Row& row) {
    numeric::Random random = random_of(row);
    Scene scene{.mesh = make_parallelogram({-20, 0, -36}, {0, 0, 40}, {40, 0, 0}, 1.0)};
    const auto anywhere = [&] { return glm::dvec3{random.uniform(-2.0, 2.0), 0, random.uniform(-4.0, 0.0)}; };
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec3 foot = anywhere();
        append(scene.mesh, make_blade(foot, {random.uniform(0.0, full_turn), random.uniform(0.12, 0.3), 0.007,
                                             random.uniform(0.0, 0.3), random.uniform(0.1, 1.1), 0.0}));
    }
    for (int i = 0; i < 40; ++i) {
        const glm::dvec3 foot = anywhere();
        const double first = random.uniform(0.0, full_turn);
        for (int k = 0; k < 7; ++k)
            append(scene.mesh, make_blade(foot, {first + full_turn * k / 7, random.uniform(0.18, 0.28), 0.09,
                                                 0.5, 1.0, 0.45}));
    }
    return scene;
}

std::function<double(double x, double z)> height_of(const Row& terrain) {
    const double size = terrain.value("size", 12.0);
    const double relief = terrain.value("relief", 3.0);
    const bool ridged = terrain.value("ridged", false);
    const std::uint64_t seed = terrain["seed"];
    return [=](double x, double z) {
        const double height = fractal_noise(x / size, z / size, 6, seed);
        return relief * (ridged ? 1.0 - 2.0 * std::abs(height) : height);
    };
}

Scene make_terrain(const Row& row) {
    const double half = row.value("half_side", 40.0);
    const auto height = height_of(row);
    Scene scene{.mesh = make_height_field(half, 220, height)};
    numeric::Random random = random_of(row);
    for (int i = 0; i < row.value("stones", 0); ++i) {
        const double x = random.uniform(-0.6 * half, 0.6 * half);
        const double z = random.uniform(-0.6 * half, 0.6 * half);
        const double radius = row.value("stone", 0.6) * random.uniform(0.4, 1.2);
        append(scene.mesh, make_stone({x, height(x, z) + 0.3 * radius, z}, radius,
                                      row["seed"].get<std::uint64_t>() + static_cast<std::uint64_t>(i)));
    }
    return scene;
}

// Blocks of houses in a grid of streets, with roofs, parapets and chimneys.
Scene make_town(const Row& row) {
    numeric::Random random = random_of(row);
    constexpr int blocks = 8;  // in each direction
    Parts parts{.cell = 4.0, .mesh = make_parallelogram({-400, 0, -400}, {0, 0, 800}, {800, 0, 0}, 10.0)};
    for (int line = 0; line < blocks; ++line) {
        for (int column = 0; column < blocks; ++column) {
            const double x = 16.0 * (column - 0.5 * blocks);
            const double z = -16.0 * line;
            const double tall = random.uniform(5.0, 18.0);
            const double wide = random.uniform(8.0, 12.0);
            parts.box({x, 0, z - wide}, {x + wide, tall, z});
            parts.box({x - 0.3, tall, z - wide - 0.3}, {x + wide + 0.3, tall + 0.5, z + 0.3});
            for (double y = 2.0; y < tall - 2.0; y += 3.0)
                parts.box({x + 1.0, y, z}, {x + wide - 1.0, y + 0.3, z + 1.0});
            const double chimney = random.uniform(1.0, wide - 2.0);
            parts.box({x + chimney, tall, z - 3.0}, {x + chimney + 1.2, tall + 3.0, z - 1.8});
        }
    }
    return {.mesh = std::move(parts.mesh)};
}

}  // namespace gloam::scene::views
