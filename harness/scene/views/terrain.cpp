// SPDX-License-Identifier: MIT
#include <cmath>

#include "numeric/random.hpp"
#include "scene/primitives.hpp"
#include "scene/views/generators.hpp"
#include "scene/views/shapes.hpp"

namespace gloam::scene::views {
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
