// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "numeric/random.hpp"
#include "scene/internal/built_in_scenes.hpp"
#include "scene/primitives.hpp"

namespace gloam::scene {
namespace {

constexpr double extent = 4.0;  // of the meadow, metres

// The shape of a blade or a leaf.
struct Shape {
    double length;
    double width;   // at its widest, metres
    double lean;    // angle from upright at the foot, radians
    double bend;    // additional lean at the tip
    double widest;  // position of the widest part, 0 to 1
};

double width_at(const Shape& shape, double t) {
    if (shape.widest > 0.0 && t < shape.widest) return shape.width * (0.3 + 0.7 * t / shape.widest);
    return shape.width * (1.0 - t) / (1.0 - shape.widest);
}

// A blade that grows from `foot` towards the azimuth `heading`, without thickness.
Mesh make_blade(const glm::dvec3& foot, double heading, const Shape& shape) {
    const glm::dvec3 ahead{std::sin(heading), 0, std::cos(heading)};
    const glm::dvec3 across{std::cos(heading), 0, -std::sin(heading)};
    constexpr int rows = 5;
    std::vector<glm::dvec3> left;
    std::vector<glm::dvec3> right;
    glm::dvec3 at = foot;
    for (int i = 0; i <= rows; ++i) {
        const double t = static_cast<double>(i) / rows;
        const glm::dvec3 half = 0.5 * width_at(shape, t) * across;
        left.push_back(at - half);
        right.push_back(at + half);
        const double lean = shape.lean + shape.bend * t;
        at += shape.length / rows * (std::cos(lean) * glm::dvec3(0, 1, 0) + std::sin(lean) * ahead);
    }
    return make_strip(left, right);
}

glm::dvec3 anywhere(numeric::Random& random) {
    const double x = random.uniform(-0.5 * extent, 0.5 * extent);
    const double z = random.uniform(-extent, 0.0);
    return {x, 0, z};
}

double any_heading(numeric::Random& random) {
    return random.uniform(0.0, 2.0 * std::numbers::pi);
}

void add_blade(Mesh& mesh, numeric::Random& random) {
    const glm::dvec3 foot = anywhere(random);
    const double heading = any_heading(random);
    const double length = random.uniform(0.12, 0.3);
    const double lean = random.uniform(0.0, 0.3);
    const double bend = random.uniform(0.1, 1.1);
    append(mesh, make_blade(foot, heading, {length, 0.007, lean, bend, 0.0}));
}

// Broad leaves around one foot.
void add_plant(Mesh& mesh, numeric::Random& random) {
    const glm::dvec3 foot = anywhere(random);
    const double first = any_heading(random);
    constexpr int leaves = 7;
    for (int i = 0; i < leaves; ++i) {
        const double heading = first + 2.0 * std::numbers::pi * i / leaves;
        const double length = random.uniform(0.18, 0.28);
        append(mesh, make_blade(foot, heading, {length, 0.09, 0.5, 1.0, 0.45}));
    }
}

}  // namespace

Scene make_grass() {
    numeric::Random random(1);
    Scene scene{.name = "grass", .mesh = make_parallelogram({-20, 0, -36}, {0, 0, 40}, {40, 0, 0}, 1.0)};
    for (int i = 0; i < 5000; ++i) add_blade(scene.mesh, random);
    for (int i = 0; i < 40; ++i) add_plant(scene.mesh, random);
    scene.camera = {.eye = {0, 0.42, 0.75},
                    .target = {0, 0.1, -0.8},
                    .fovy_rad = 0.8,
                    .near = 0.05,
                    .far = 60.0,
                    .reversed_z = true};
    scene.camera_path = [start = scene.camera](int frame) {
        Camera camera = start;
        const glm::dvec3 move{0.3 * std::sin(0.02 * frame), 0.0, 0.1 * std::sin(0.013 * frame)};
        camera.eye += move;
        camera.target += move;
        return camera;
    };
    scene.ao_radius = 0.15;
    return scene;
}

}  // namespace gloam::scene
