// SPDX-License-Identifier: MIT
#include <cmath>

#include "numeric/random.hpp"
#include "scene/primitives.hpp"
#include "scene/views/generators.hpp"
#include "scene/views/shapes.hpp"

namespace gloam::scene::views {
namespace {

constexpr double machine_cell = 0.5;

// A toothed wheel that stands upright, its axis along z.
Mesh make_gear(const glm::dvec3& center, double radius, int teeth) {
    constexpr double thick = 0.08;
    Mesh mesh = make_rod(center - glm::dvec3(0, 0, thick), center + glm::dvec3(0, 0, thick), radius, 48);
    append(mesh, make_rod(center - glm::dvec3(0, 0, 0.3), center + glm::dvec3(0, 0, 0.2), 0.2 * radius, 24));
    const double tooth = 0.2 * full_turn * radius / teeth;
    for (int i = 0; i < teeth; ++i) {
        const double angle = full_turn * i / teeth;
        const glm::dvec3 out{std::cos(angle), std::sin(angle), 0};
        append(mesh, make_rod(center + 0.95 * radius * out, center + (radius + 2.0 * tooth) * out, tooth, 6));
    }
    return mesh;
}

// A pipe through corners, with a flange at each.
Mesh make_pipe(const std::vector<glm::dvec3>& corners, double radius) {
    Mesh mesh;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        append(mesh, make_rod(corners[i], corners[i + 1], radius, 20));
        append(mesh, make_sphere(corners[i + 1], 1.05 * radius, 12, 24));
        const glm::dvec3 way = glm::normalize(corners[i + 1] - corners[i]);
        const glm::dvec3 middle = 0.5 * (corners[i] + corners[i + 1]);
        append(mesh, make_rod(middle - 0.04 * way, middle + 0.04 * way, 1.4 * radius, 20));
    }
    return mesh;
}

// A grating of bars on the plane y, with gaps between them.
Mesh make_grating(const glm::dvec3& low, const glm::dvec3& high, double spacing) {
    Mesh mesh;
    for (double x = low.x; x <= high.x; x += spacing)
        append(mesh, make_box({x, low.y, low.z}, {x + 0.25 * spacing, high.y, high.z}, 4.0));
    for (double z = low.z; z <= high.z; z += 3.0 * spacing)
        append(mesh, make_box({low.x, low.y, z}, {high.x, high.y, z + 0.25 * spacing}, 4.0));
    return mesh;
}

// A housing with fins, bolts and a dial.
Mesh make_housing(numeric::Random& random, const glm::dvec3& low, const glm::dvec3& size) {
    Mesh mesh = make_box(low, low + size, machine_cell);
    for (double x = 0.1; x < size.x - 0.1; x += 0.12)
        append(mesh, make_box(low + glm::dvec3(x, size.y, 0.1),
                              low + glm::dvec3(x + 0.03, size.y + 0.12, size.z - 0.1), machine_cell));
    for (const double x : {0.08, size.x - 0.08})
        for (const double y : {0.08, size.y - 0.08})
            append(mesh,
                   make_rod(low + glm::dvec3(x, y, size.z), low + glm::dvec3(x, y, size.z + 0.04), 0.04, 6));
    const double dial = random.uniform(0.1, 0.2);
    const glm::dvec3 middle = low + glm::dvec3(0.5 * size.x, 0.5 * size.y, size.z);
    append(mesh, make_rod(middle, middle + glm::dvec3(0, 0, 0.08), dial, 32));
    return mesh;
}

glm::dvec3 scattered(numeric::Random& random, double x, double y, double z) {
    return {x + random.uniform(-0.1, 0.1), y + random.uniform(-0.05, 0.05), z};
}

}  // namespace

Scene make_machine(const Machine& machine) {
    numeric::Random random(machine.seed);
    Scene scene{.mesh = make_parallelogram({-20, 0, -20}, {0, 0, 40}, {40, 0, 0}, 1.0)};
    append(scene.mesh, make_box({-6, 0, -2.2}, {6, 5, -2.0}, 1.0));
    for (int i = 0; i < machine.parts; ++i) {
        const double x = -2.4 + 4.8 * (i + 0.5) / machine.parts;
        const double tall = random.uniform(0.5, 1.3);
        append(scene.mesh, make_housing(random, {x - 0.35, 0, -1.2},
                                        {random.uniform(0.5, 0.75), tall, random.uniform(0.5, 0.9)}));
        const double radius = random.uniform(0.2, 0.4);
        append(scene.mesh, make_gear(scattered(random, x, 0.5 + tall, -1.5), radius,
                                     10 + static_cast<int>(random.below(8))));
    }
    for (int i = 0; i < machine.pipes; ++i) {
        const double y = 0.3 + 2.0 * (i + 0.5) / machine.pipes;
        const double z = random.uniform(-1.9, -0.4);
        const double turn = random.uniform(-1.5, 1.5);
        append(scene.mesh, make_pipe({{-4, y, z}, {turn, y, z}, {turn, y, z + 0.6}, {turn, 0, z + 0.6}},
                                     random.uniform(0.04, 0.1)));
    }
    if (machine.grating) append(scene.mesh, make_grating({-2.5, 0.25, -0.3}, {2.5, 0.29, 1.5}, 0.12));
    scene.ao_radius = machine.radius;
    return scene;
}

}  // namespace gloam::scene::views
