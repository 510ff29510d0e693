// SPDX-License-Identifier: MIT
#include <cmath>

#include "numeric/random.hpp"
#include "scene/primitives.hpp"
#include "scene/views/generators.hpp"
#include "scene/views/shapes.hpp"

namespace gloam::scene::views {
namespace {

constexpr double hall_cell = 2.0;

// A pillar with a base and a capital.
Mesh make_pillar(const glm::dvec3& foot, double height) {
    Mesh mesh = make_box(foot - glm::dvec3(0.4, 0, 0.4), foot + glm::dvec3(0.4, 0.3, 0.4), hall_cell);
    append(mesh, make_cylinder(foot + glm::dvec3(0, 0.3, 0), 0.28, height - 0.6, 32));
    append(mesh, make_box(foot + glm::dvec3(-0.4, height - 0.3, -0.4), foot + glm::dvec3(0.4, height, 0.4),
                          hall_cell));
    return mesh;
}

// A flight of steps up along -z.
Mesh make_stairs(const glm::dvec3& foot, double width, int steps) {
    Mesh mesh;
    for (int i = 0; i < steps; ++i) {
        const double z = foot.z - 0.3 * i;
        append(mesh, make_box({foot.x - 0.5 * width, foot.y, z - 0.3},
                              {foot.x + 0.5 * width, foot.y + 0.17 * (i + 1), z}, hall_cell));
    }
    return mesh;
}

// A railing: posts and a rail.
Mesh make_railing(const glm::dvec3& from, const glm::dvec3& to, int posts) {
    Mesh mesh = make_rod(from + glm::dvec3(0, 0.9, 0), to + glm::dvec3(0, 0.9, 0), 0.03, 12);
    for (int i = 0; i < posts; ++i) {
        const glm::dvec3 at = from + (to - from) * (static_cast<double>(i) / (posts - 1));
        append(mesh, make_rod(at, at + glm::dvec3(0, 0.9, 0), 0.015, 8));
    }
    return mesh;
}

// Niches in the wall x = side: blocks between them.
Mesh make_niches(double side, double length, double height) {
    Mesh mesh;
    const double inwards = side > 0.0 ? -0.5 : 0.5;
    for (double z = -length; z < 0.0; z += 2.4)
        append(mesh, make_box({std::min(side, side + inwards), 0, z},
                              {std::max(side, side + inwards), height, z + 1.2}, hall_cell));
    return mesh;
}

}  // namespace

// A hall with niches, pillars, beams, stairs with railings.
Scene make_hall(const Hall& hall) {
    const double w = hall.half_width;
    Scene scene{.mesh = inside_out(make_box({-w, 0, -hall.length}, {w, hall.height, 2.0}, hall_cell))};
    append(scene.mesh, make_niches(-w, hall.length, hall.height));
    append(scene.mesh, make_niches(w, hall.length, hall.height));
    for (double z = -hall.length + 1.2; z < 1.0; z += 2.4) {
        append(scene.mesh, make_box({-w, hall.height - 0.4, z - 0.2}, {w, hall.height, z + 0.2}, hall_cell));
        for (const double x : {-hall.pillars, hall.pillars})
            append(scene.mesh, make_pillar({x, 0, z}, hall.height - 0.4));
    }
    append(scene.mesh, make_stairs({0, 0, -0.5 * hall.length}, 1.6, 9));
    for (const double x : {-0.85, 0.85})
        append(scene.mesh,
               make_railing({x, 0.1, -0.5 * hall.length}, {x, 1.6, -0.5 * hall.length - 2.7}, 10));
    numeric::Random random(hall.seed);
    for (int i = 0; i < 12; ++i) {
        const double radius = random.uniform(0.1, 0.35);
        const double x = random.uniform(-w + 0.9, w - 0.9);
        const double z = random.uniform(-hall.length + 1.0, -0.5);
        append(scene.mesh, make_sphere({x, radius, z}, radius, 24, 48));
    }
    scene.ao_radius = hall.radius;
    scene.lamp = glm::dvec3(0.2, hall.height - 0.8, -1.5);
    return scene;
}

}  // namespace gloam::scene::views
