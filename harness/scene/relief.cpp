// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "scene/internal/built_in_scenes.hpp"
#include "scene/primitives.hpp"

namespace gloam::scene {
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

}  // namespace gloam::scene
