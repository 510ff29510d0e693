// SPDX-License-Identifier: MIT
#include <cmath>

#include "scene/views/generators.hpp"

namespace gloam::scene::views {
namespace {

// 128 km away. Static objects consist of exact multiples of 1/128.
constexpr glm::dvec3 there{98304.0, 512.0, -81920.0};  // floats are 1/128 apart

Parts make_terrace() {
    Parts terrace{.cell = 16.0};
    terrace.mesh = make_parallelogram(there + glm::dvec3(-8, 0, -8), {0, 0, 16}, {16, 0, 0}, 1.0);
    const auto add = [&](const glm::dvec3& low, const glm::dvec3& high) {
        terrace.box(there + low, there + high);
    };
    add({-8, 0, -4}, {8, 3, -3.5});
    for (int i = -2; i <= 2; ++i) add({1.5 * i - 0.25, 0, -3.5}, {1.5 * i + 0.25, 2.5, -3.25});
    for (int i = 0; i < 5; ++i) add({-3, 0.25 * i, -1.5 - 0.375 * i}, {-1, 0.25 * (i + 1), -3.25});
    add({0.5, 0, -2}, {1.5, 1, -1});
    add({0.75, 1, -1.75}, {1.25, 1.5, -1.25});
    return terrace;
}

}  // namespace

Scene make_far(const Row& /*row*/) {
    Scene scene{.mesh = make_terrace().mesh};
    // Round objects have an object space of their own, so that their shape stays exact.
    scene.objects.push_back({make_sphere({0, 0, 0}, 0.5, 48, 96),
                             [](int) { return rigid_motion(there + glm::dvec3(-0.4, 0.5, -0.5)); }});
    scene.objects.push_back({make_sphere({0, 0, 0}, 0.25, 48, 96), [](int frame) {
                                 const double x = 2.0 + 0.6 * std::sin(0.02 * frame);
                                 return rigid_motion(there + glm::dvec3(x, 0.25, -0.2), -x / 0.25, {0, 0, 1});
                             }});
    return scene;
}

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

}  // namespace

Scene make_grass(const Row& /*row*/) {
    numeric::Random random(1);
    Scene scene{.mesh = make_parallelogram({-20, 0, -36}, {0, 0, 40}, {40, 0, 0}, 1.0)};
    const auto anywhere = [&] {
        const double x = random.uniform(-0.5 * extent, 0.5 * extent);
        const double z = random.uniform(-extent, 0.0);
        return glm::dvec3(x, 0, z);
    };
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec3 foot = anywhere();
        const double heading = random.uniform(0.0, full_turn);
        const double length = random.uniform(0.12, 0.3);
        const double lean = random.uniform(0.0, 0.3);
        const double bend = random.uniform(0.1, 1.1);
        append(scene.mesh, make_blade(foot, heading, {length, 0.007, lean, bend, 0.0}));
    }
    for (int i = 0; i < 40; ++i) {  // broad leaves around one foot
        const glm::dvec3 foot = anywhere();
        const double first = random.uniform(0.0, full_turn);
        constexpr int leaves = 7;
        for (int k = 0; k < leaves; ++k) {
            const double heading = first + full_turn * k / leaves;
            const double length = random.uniform(0.18, 0.28);
            append(scene.mesh, make_blade(foot, heading, {length, 0.09, 0.5, 1.0, 0.45}));
        }
    }
    return scene;
}

namespace {

// Metres. The panel hangs on a pilaster of the hall, around z = -5.
constexpr double face = -6.7;  // x of the wall
constexpr double middle = -5.0;
constexpr double low = 1.2;
constexpr double high = 2.0;
constexpr double half_width = 0.35;

// Four bars around it.
void add_frame_bars(Parts& panel) {
    constexpr double bar = 0.04;
    constexpr double proud = face + 0.03;
    for (const double z : {middle - half_width, middle + half_width - bar})
        panel.box({face, low, z}, {proud, high, z + bar});
    for (const double y : {low, high - bar})
        panel.box({face, y, middle - half_width}, {proud, y + bar, middle + half_width});
}

// Ridges a finger wide, upright in the lower half.
void add_ridges(Parts& panel) {
    for (int i = 0; i < 16; ++i)
        panel.cylinder({face, low + 0.04, middle - half_width + 0.05 + 0.04 * i}, 0.013, 0.3, 24);
    panel.box({face, low + 0.34, middle - half_width}, {face + 0.02, low + 0.37, middle + half_width});
}

// A flower of balls sunk into the face, in the upper half.
void add_flower(Parts& panel) {
    constexpr double height = low + 0.57;
    panel.sphere({face, height, middle}, 0.05, 16, 32);
    const auto ring = [&](int count, double distance, double radius) {
        for (int i = 0; i < count; ++i) {
            const double angle = full_turn * i / count;
            panel.sphere({face, height + distance * std::cos(angle), middle + distance * std::sin(angle)},
                         radius, 12, 24);
        }
    };
    ring(8, 0.085, 0.028);
    ring(24, 0.15, 0.014);
}

}  // namespace

// The same world and radius as the hall, at arm's length from a wall.
Scene make_relief(const Row& row) {
    Scene scene = make_columns(row);
    Parts panel{.cell = 0.5, .mesh = std::move(scene.mesh)};
    add_frame_bars(panel);
    add_ridges(panel);
    add_flower(panel);
    scene.mesh = std::move(panel.mesh);
    scene.lamp = glm::dvec3(face + 1.5, 3.2, middle - 1.0);
    return scene;
}

Scene make_sky(const Row& /*row*/) {
    Parts parts{.mesh = make_parallelogram({-150, 0, -300}, {0, 0, 310}, {300, 0, 0}, 5.0)};
    for (int i = 0; i < 8; ++i) {  // masts with two arms
        constexpr double x = -2.0;
        const double z = -9.0 - 18.0 * i;
        parts.cylinder({x, 0, z}, 0.12, 7.0, 24);
        parts.box({x - 0.9, 6.2, z - 0.06}, {x + 0.9, 6.35, z + 0.06});
        parts.box({x - 0.6, 5.5, z - 0.06}, {x + 0.6, 5.65, z + 0.06});
    }
    // Straight wires of a square section from mast to mast.
    const auto wire = [&](double x, double y) {
        parts.box({x - 0.012, y, -135.0}, {x + 0.012, y + 0.024, 5.0});
    };
    for (const double x : {-2.85, -1.15}) wire(x, 6.35);
    for (const double x : {-2.55, -1.45}) wire(x, 5.65);
    parts.box({4, 0, -40}, {9, 2.6, -34});  // a hut
    Scene scene{.mesh = std::move(parts.mesh)};
    // A circling kite: its history meets the sky, which has none.
    scene.objects.push_back({make_box({-0.4, -0.03, -0.3}, {0.4, 0.03, 0.3}, 1.0), [](int frame) {
                                 const double t = 0.03 * frame;
                                 const glm::dvec3 at{1.5 + 1.2 * std::cos(t), 5.0 + std::sin(t), -9.0};
                                 return rigid_motion(at, 0.5 + 0.7 * t, {0.6, 0.8, 0});
                             }});
    return scene;
}

// A floor, a wall with pilasters, steps in front of it.
Scene make_moving(const Row& /*row*/) {
    Parts parts{.mesh = make_parallelogram({-8, 0, -3}, {0, 0, 10}, {16, 0, 0}, 1.0)};
    parts.add(make_parallelogram({-8, 0, -3}, {16, 0, 0}, {0, 6, 0}, 1.0));
    for (int i = -3; i <= 3; ++i) parts.box({i - 0.15, 0, -3}, {i + 0.15, 6, -2.75});
    parts.box({-8, 0, -2.75}, {8, 0.25, -2.25});
    parts.box({-8, 0, -2.25}, {8, 0.125, -1.75});
    Scene scene{.mesh = std::move(parts.mesh)};
    // A ball rolls from side to side without slipping; a box turns while it slides the opposite way.
    constexpr double ball = 0.35;
    scene.objects.push_back({make_sphere({0, 0, 0}, ball, 48, 96), [](int frame) {
                                 const double x = 1.3 * std::sin(0.03 * frame);
                                 return rigid_motion({x, ball, -1.0}, -x / ball, {0, 0, 1});
                             }});
    scene.objects.push_back({make_box({-0.3, 0, -0.2}, {0.3, 0.7, 0.2}, 1.0), [](int frame) {
                                 const double x = -0.9 * std::cos(0.023 * frame);
                                 return rigid_motion({x, 0, -0.1}, 0.02 * frame);
                             }});
    return scene;
}

namespace {

// A tube around a trefoil knot, upright; smooth normals outwards.
Mesh make_trefoil() {
    constexpr int along = 240;
    constexpr int around = 32;
    constexpr double radius = 0.55;
    const auto curve = [](double part) -> glm::dvec3 {
        const double t = full_turn * part;
        return {std::sin(t) + 2.0 * std::sin(2.0 * t), std::cos(t) - 2.0 * std::cos(2.0 * t),
                -std::sin(3.0 * t)};
    };
    return make_grid(around, along, [&](int x, int y) -> Vertex {
        const double t = static_cast<double>(y % along) / along;
        constexpr double step = 1e-4;
        const glm::dvec3 forward = glm::normalize(curve(t + step) - curve(t - step));
        const glm::dvec3 side = glm::normalize(glm::cross(forward, glm::dvec3(0, 0, 1)));
        const double angle = full_turn * (x % around) / around;
        const glm::dvec3 out = std::cos(angle) * side + std::sin(angle) * glm::cross(forward, side);
        return {curve(t) + radius * out, out};
    });
}

}  // namespace

Scene make_knot(const Row& /*row*/) {
    constexpr double scale = 0.17;
    Mesh knot = make_trefoil();
    knot = placed(std::move(knot), scale, {0, -scale * bounds_of(knot).low.y, 0});
    Scene scene{.mesh = std::move(knot)};
    append(scene.mesh, make_parallelogram({-6, 0, -0.45}, {0, 0, 6.45}, {12, 0, 0}, 0.5));  // the ground
    append(scene.mesh, make_parallelogram({-6, 0, -0.45}, {12, 0, 0}, {0, 6, 0}, 0.5));     // the wall
    return scene;
}

}  // namespace gloam::scene::views
