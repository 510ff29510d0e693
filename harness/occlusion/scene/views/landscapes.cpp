// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "numeric/random.hpp"
#include "scene/mesh.hpp"
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

// A flat leaf without thickness, which grows from `foot` in a direction and droops.
Mesh make_leaf(numeric::Random& random, const glm::dvec3& foot, glm::dvec3 ahead, double length,
               double width) {
    const glm::dvec3 side = glm::normalize(glm::cross(ahead, any_direction(random)));
    std::vector<glm::dvec3> left;
    std::vector<glm::dvec3> right;
    glm::dvec3 at = foot;
    constexpr int rows = 4;
    for (int i = 0; i <= rows; ++i) {
        const double t = static_cast<double>(i) / rows;
        const glm::dvec3 half = 0.5 * width * std::sin(std::numbers::pi * (0.1 + 0.85 * t)) * side;
        left.push_back(at - half);
        right.push_back(at + half);
        at += length / rows * ahead;
        ahead = glm::normalize(ahead - glm::dvec3(0, 0.15, 0));
    }
    return make_strip(left, right);
}

// Leaves in a ball, denser near its surface, as of a bush or a crown.
void add_crown(Mesh& mesh, numeric::Random& random, const glm::dvec3& center, double radius, int leaves,
               double leaf) {
    for (int i = 0; i < leaves; ++i) {
        const glm::dvec3 out = any_direction(random);
        const double far = radius * std::sqrt(random.uniform(0.15, 1.0));
        append(mesh, make_leaf(random, center + far * out, out, random.uniform(0.7, 1.3) * leaf, 0.5 * leaf));
    }
}

void add_tree(Mesh& mesh, numeric::Random& random, const glm::dvec3& foot, const Foliage& foliage) {
    const double height = random.uniform(0.8, 1.2) * foliage.trunk;
    const glm::dvec3 top = foot + glm::dvec3(0.05 * height, height, 0.03 * height);
    append(mesh, make_rod(foot, top, 0.06 * height, 12));
    for (int i = 0; i < 6; ++i) {
        const glm::dvec3 from = foot + random.uniform(0.5, 0.95) * (top - foot);
        const glm::dvec3 aside = any_direction(random) * glm::dvec3(1, 0.3, 1);
        const glm::dvec3 to = from + height * (0.25 * aside + glm::dvec3(0, 0.2, 0));
        append(mesh, make_rod(from, to, 0.015 * height, 8));
        add_crown(mesh, random, to, 0.25 * height, foliage.leaves / 8, foliage.leaf);
    }
    add_crown(mesh, random, top + glm::dvec3(0, 0.15 * height, 0), 0.35 * height, foliage.leaves / 4,
              foliage.leaf);
}

// Blades of grass over the square of half the side `half` around the origin.
void add_meadow(Mesh& mesh, numeric::Random& random, double half, const Foliage& foliage) {
    for (int i = 0; i < foliage.blades; ++i) {
        const glm::dvec3 foot{random.uniform(-half, half), 0, random.uniform(-half, half)};
        const double around = random.uniform(0.0, full_turn);
        const glm::dvec3 up = glm::normalize(glm::dvec3(0.4 * std::cos(around), 1.0, 0.4 * std::sin(around)));
        append(mesh,
               make_leaf(random, foot, up, random.uniform(0.6, 1.4) * foliage.blade, 0.08 * foliage.blade));
    }
}

}  // namespace

Scene make_foliage(const Foliage& foliage) {
    numeric::Random random(foliage.seed);
    Scene scene{.mesh = make_parallelogram({-30, 0, -30}, {0, 0, 60}, {60, 0, 0}, 2.0)};
    for (int i = 0; i < foliage.trees; ++i) {
        const double x = random.uniform(-foliage.half, foliage.half);
        const double z = random.uniform(-foliage.half, foliage.half);
        add_tree(scene.mesh, random, {x, 0, z}, foliage);
    }
    for (int i = 0; i < foliage.bushes; ++i) {
        const double radius = random.uniform(0.25, 0.45);
        const double x = random.uniform(-foliage.half, foliage.half);
        const double z = random.uniform(-foliage.half, foliage.half);
        add_crown(scene.mesh, random, {x, 0.8 * radius, z}, radius, foliage.leaves, foliage.leaf);
    }
    add_meadow(scene.mesh, random, foliage.half, foliage);
    scene.ao_radius = foliage.radius;
    return scene;
}

namespace {

// A stone: a sphere whose radius varies smoothly.
Mesh make_stone(const glm::dvec3& center, double radius, std::uint64_t seed) {
    Mesh mesh = make_sphere({0, 0, 0}, 1.0, 20, 40);
    for (glm::vec3& p : mesh.positions) {
        const double rough = fractal_noise(1.5 * p.x + 7.0 + p.y, 1.5 * p.z + 7.0 - p.y, 3, seed);
        p = center + radius * (1.0 + 0.3 * rough) * glm::dvec3(p);
    }
    return mesh;
}

double height_at(const Terrain& terrain, double x, double z) {
    double height = fractal_noise(x / terrain.size, z / terrain.size, 6, terrain.seed);
    if (terrain.ridged) height = 1.0 - 2.0 * std::abs(height);
    return terrain.relief * height;
}

}  // namespace

Scene make_terrain(const Terrain& terrain) {
    Scene scene{.mesh = make_height_field(terrain.half, 220,
                                          [&](double x, double z) { return height_at(terrain, x, z); })};
    numeric::Random random(terrain.seed);
    for (int i = 0; i < terrain.stones; ++i) {
        const double x = random.uniform(-0.6 * terrain.half, 0.6 * terrain.half);
        const double z = random.uniform(-0.6 * terrain.half, 0.6 * terrain.half);
        const double radius = terrain.stone * random.uniform(0.4, 1.2);
        append(scene.mesh, make_stone({x, height_at(terrain, x, z) + 0.3 * radius, z}, radius,
                                      terrain.seed + static_cast<std::uint64_t>(i)));
    }
    scene.ao_radius = terrain.radius;
    return scene;
}

double terrain_height(const Terrain& terrain, double x, double z) {
    return height_at(terrain, x, z);
}

// Blocks of houses in a grid of streets, with roofs, parapets and chimneys.
Scene make_town(const Town& town) {
    numeric::Random random(town.seed);
    Scene scene{.mesh = make_parallelogram({-400, 0, -400}, {0, 0, 800}, {800, 0, 0}, 10.0)};
    for (int row = 0; row < town.blocks; ++row) {
        for (int column = 0; column < town.blocks; ++column) {
            const double x = 16.0 * (column - 0.5 * town.blocks);
            const double z = -16.0 * row;
            const double tall = random.uniform(5.0, town.tallest);
            const double wide = random.uniform(8.0, 12.0);
            append(scene.mesh, make_box({x, 0, z - wide}, {x + wide, tall, z}, 4.0));
            append(scene.mesh,
                   make_box({x - 0.3, tall, z - wide - 0.3}, {x + wide + 0.3, tall + 0.5, z + 0.3}, 4.0));
            for (double y = 2.0; y < tall - 2.0; y += 3.0)
                append(scene.mesh, make_box({x + 1.0, y, z}, {x + wide - 1.0, y + 0.3, z + 1.0}, 4.0));
            const double chimney = random.uniform(1.0, wide - 2.0);
            append(scene.mesh,
                   make_box({x + chimney, tall, z - 3.0}, {x + chimney + 1.2, tall + 3.0, z - 1.8}, 4.0));
        }
    }
    scene.ao_radius = town.radius;
    return scene;
}

}  // namespace gloam::scene::views
