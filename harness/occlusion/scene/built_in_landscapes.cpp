// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "numeric/random.hpp"
#include "scene/internal/built_in_scenes.hpp"
#include "scene/mesh.hpp"

namespace gloam::scene {
namespace {

// 128 km away: floats are 1/128 apart on each axis. Static objects consist of exact multiples of that.
constexpr glm::dvec3 there{98304.0, 512.0, -81920.0};

Mesh make_terrace() {
    Mesh mesh = make_parallelogram(there + glm::dvec3(-8, 0, -8), {0, 0, 16}, {16, 0, 0}, 1.0);
    const auto add = [&](const glm::dvec3& low, const glm::dvec3& high) {
        append(mesh, make_box(there + low, there + high, 16.0));
    };
    add({-8, 0, -4}, {8, 3, -3.5});
    for (int i = -2; i <= 2; ++i) add({1.5 * i - 0.25, 0, -3.5}, {1.5 * i + 0.25, 2.5, -3.25});
    for (int i = 0; i < 5; ++i) add({-3, 0.25 * i, -1.5 - 0.375 * i}, {-1, 0.25 * (i + 1), -3.25});
    add({0.5, 0, -2}, {1.5, 1, -1});
    add({0.75, 1, -1.75}, {1.25, 1.5, -1.25});
    return mesh;
}

}  // namespace

Scene make_far() {
    Scene scene{.name = "far", .mesh = make_terrace()};
    // Round objects have an object space of their own, so that their shape stays exact.
    scene.objects.push_back({make_sphere({0, 0, 0}, 0.5, 48, 96),
                             [](int) { return rigid_motion(there + glm::dvec3(-0.4, 0.5, -0.5)); }});
    scene.objects.push_back({make_sphere({0, 0, 0}, 0.25, 48, 96), [](int frame) {
                                 const double x = 2.0 + 0.6 * std::sin(0.02 * frame);
                                 return rigid_motion(there + glm::dvec3(x, 0.25, -0.2), -x / 0.25, {0, 0, 1});
                             }});
    scene.camera = {.eye = there + glm::dvec3(1.2, 1.6, 3.2),
                    .target = there + glm::dvec3(-0.1, 0.6, -1.5),
                    .fovy_rad = 0.8,
                    .near = 0.1,
                    .far = 60.0,
                    .reversed_z = true};
    // Moves by less than the spacing of floats from frame to frame.
    scene.camera_path = [start = scene.camera](int frame) {
        Camera camera = start;
        camera.eye += glm::dvec3(-0.4 * std::sin(0.01 * frame), 0.0, 0.1 * std::sin(0.013 * frame));
        return camera;
    };
    scene.ao_radius = 0.4;
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

namespace {

// Metres. The panel hangs on a pilaster of the hall, with the face x = -6.7, around z = -5.
constexpr double face = -6.7;
constexpr double middle = -5.0;
constexpr double low = 1.2;
constexpr double high = 2.0;
constexpr double half_width = 0.35;
constexpr double relief_cell = 0.5;

// Four bars around it.
Mesh make_frame_bars() {
    constexpr double bar = 0.04;
    constexpr double proud = face + 0.03;
    Mesh mesh;
    for (const double z : {middle - half_width, middle + half_width - bar})
        append(mesh, make_box({face, low, z}, {proud, high, z + bar}, relief_cell));
    for (const double y : {low, high - bar})
        append(mesh,
               make_box({face, y, middle - half_width}, {proud, y + bar, middle + half_width}, relief_cell));
    return mesh;
}

// Ridges a finger wide, upright in the lower half.
Mesh make_ridges() {
    Mesh mesh;
    for (int i = 0; i < 16; ++i) {
        const double z = middle - half_width + 0.05 + 0.04 * i;
        append(mesh, make_cylinder({face, low + 0.04, z}, 0.013, 0.3, 24));
    }
    append(mesh, make_box({face, low + 0.34, middle - half_width},
                          {face + 0.02, low + 0.37, middle + half_width}, relief_cell));
    return mesh;
}

// A flower of balls sunk into the face, in the upper half.
Mesh make_flower() {
    constexpr double height = low + 0.57;
    Mesh mesh = make_sphere({face, height, middle}, 0.05, 16, 32);
    const auto ring = [&](int count, double distance, double radius) {
        for (int i = 0; i < count; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / count;
            const glm::dvec3 center{face, height + distance * std::cos(angle),
                                    middle + distance * std::sin(angle)};
            append(mesh, make_sphere(center, radius, 12, 24));
        }
    };
    ring(8, 0.085, 0.028);
    ring(24, 0.15, 0.014);
    return mesh;
}

}  // namespace

// The same world and radius as the hall, at arm's length from a wall.
Scene make_relief() {
    Scene scene = make_columns();
    scene.name = "relief";
    for (const Mesh& part : {make_frame_bars(), make_ridges(), make_flower()}) append(scene.mesh, part);
    scene.camera.eye = {face + 0.75, 1.75, middle + 0.35};
    scene.camera.target = {face, 1.58, middle};
    scene.camera_path = [start = scene.camera](int frame) {
        Camera camera = start;
        camera.eye += glm::dvec3(0.0, 0.01 * std::sin(0.11 * frame), 0.06 * std::sin(0.05 * frame));
        return camera;
    };
    scene.lamp = glm::dvec3(face + 1.5, 3.2, middle - 1.0);
    return scene;
}

namespace {

// A mast with two arms, at a position on the ground.
Mesh make_mast(double x, double z) {
    Mesh mast = make_cylinder({x, 0, z}, 0.12, 7.0, 24);
    append(mast, make_box({x - 0.9, 6.2, z - 0.06}, {x + 0.9, 6.35, z + 0.06}, 1.0));
    append(mast, make_box({x - 0.6, 5.5, z - 0.06}, {x + 0.6, 5.65, z + 0.06}, 1.0));
    return mast;
}

// A straight wire of a square section from mast to mast.
Mesh make_wire(double x, double y, double z_far, double z_near) {
    return make_box({x - 0.012, y, z_far}, {x + 0.012, y + 0.024, z_near}, 1.0);
}

}  // namespace

Scene make_sky() {
    Scene scene{.name = "sky", .mesh = make_parallelogram({-150, 0, -300}, {0, 0, 310}, {300, 0, 0}, 5.0)};
    for (int i = 0; i < 8; ++i) append(scene.mesh, make_mast(-2.0, -9.0 - 18.0 * i));
    for (const double x : {-2.85, -1.15}) append(scene.mesh, make_wire(x, 6.35, -135.0, 5.0));
    for (const double x : {-2.55, -1.45}) append(scene.mesh, make_wire(x, 5.65, -135.0, 5.0));
    append(scene.mesh, make_box({4, 0, -40}, {9, 2.6, -34}, 1.0));  // a hut
    // A circling kite: its history meets the sky, which has none.
    scene.objects.push_back({make_box({-0.4, -0.03, -0.3}, {0.4, 0.03, 0.3}, 1.0), [](int frame) {
                                 const double t = 0.03 * frame;
                                 const glm::dvec3 at{1.5 + 1.2 * std::cos(t), 5.0 + std::sin(t), -9.0};
                                 return rigid_motion(at, 0.5 + 0.7 * t, {0.6, 0.8, 0});
                             }});
    scene.camera = {.eye = {0, 1.7, 0},
                    .target = {0, 4.7, -9.0},
                    .fovy_rad = 0.8,
                    .near = 0.1,
                    .far = 500.0,
                    .reversed_z = true};
    scene.camera_path = [start = scene.camera](int frame) {
        Camera camera = start;
        camera.target.x += 1.5 * std::sin(0.02 * frame);
        camera.eye.z -= 0.5 * std::sin(0.01 * frame);
        return camera;
    };
    scene.ao_radius = 0.6;
    return scene;
}

namespace {

// A floor, a wall with pilasters, steps in front of it.
Mesh make_background() {
    Mesh mesh = make_parallelogram({-8, 0, -3}, {0, 0, 10}, {16, 0, 0}, 1.0);
    append(mesh, make_parallelogram({-8, 0, -3}, {16, 0, 0}, {0, 6, 0}, 1.0));
    for (int i = -3; i <= 3; ++i) append(mesh, make_box({i - 0.15, 0, -3}, {i + 0.15, 6, -2.75}, 1.0));
    append(mesh, make_box({-8, 0, -2.75}, {8, 0.25, -2.25}, 1.0));
    append(mesh, make_box({-8, 0, -2.25}, {8, 0.125, -1.75}, 1.0));
    return mesh;
}

}  // namespace

Scene make_moving() {
    Scene scene{.name = "moving", .mesh = make_background()};
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
    scene.camera = {.eye = {0.3, 1.3, 3.0},
                    .target = {0, 0.5, -1.0},
                    .fovy_rad = 0.8,
                    .near = 0.1,
                    .far = 60.0,
                    .reversed_z = true};
    scene.camera_path = [start = scene.camera](int frame) {
        Camera camera = start;
        camera.eye += glm::dvec3(0.5 * std::sin(0.017 * frame), 0.0, 0.2 * std::sin(0.011 * frame));
        return camera;
    };
    scene.ao_radius = 0.4;
    return scene;
}

namespace {

// A trefoil knot, upright.
glm::dvec3 trefoil(double part) {
    const double t = 2.0 * std::numbers::pi * part;
    return {std::sin(t) + 2.0 * std::sin(2.0 * t), std::cos(t) - 2.0 * std::cos(2.0 * t), -std::sin(3.0 * t)};
}

}  // namespace

Scene make_knot() {
    Mesh knot = make_tube(trefoil, 0.55, 240, 32);
    constexpr double scale = 0.17;
    knot = placed(std::move(knot), scale, {0, -scale * bounds_of(knot).low.y, 0});
    Scene scene{.name = "knot", .mesh = std::move(knot)};
    append(scene.mesh, make_parallelogram({-6, 0, -0.45}, {0, 0, 6.45}, {12, 0, 0}, 0.5));  // the ground
    append(scene.mesh, make_parallelogram({-6, 0, -0.45}, {12, 0, 0}, {0, 6, 0}, 0.5));     // the wall
    scene.camera = {.eye = {0.9, 0.95, 2.0},
                    .target = {0, 0.48, 0},
                    .fovy_rad = 0.7,
                    .near = 0.1,
                    .far = 40.0,
                    .reversed_z = true};
    scene.camera_path = [start = scene.camera](int frame) {
        Camera camera = start;
        const double angle = std::atan2(0.9, 2.0) + 0.5 * (std::cos(0.02 * frame) - 1.0);
        const double distance = std::hypot(0.9, 2.0);
        camera.eye = {distance * std::sin(angle), start.eye.y, distance * std::cos(angle)};
        return camera;
    };
    scene.ao_radius = 0.25;
    return scene;
}

}  // namespace gloam::scene
