// SPDX-License-Identifier: MIT
#include "scene/corner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scene/internal/built_in_scenes.hpp"
#include "scene/primitives.hpp"

namespace gloam::scene {
namespace {

// Integral of (1 - c / cos t)^2 over t from -arccos(c) to `end`, for a wall at c = a / R; 0 beyond the
// radius.
double wall_integral(double c, double end) {
    if (c >= 1.0) return 0.0;
    const auto antiderivative = [c](double t) {
        const double tangent = std::tan(t);
        return t - 2.0 * c * std::asinh(tangent) + c * c * tangent;
    };
    const double reach = std::acos(c);
    return antiderivative(std::clamp(end, -reach, reach)) - antiderivative(-reach);
}

}  // namespace

double corner_occlusion(double a, double b, double radius) {
    // The azimuth of the corner's edge, where the nearer wall changes; measured from the first wall's normal.
    const double edge = std::atan2(b, a);
    const double sum =
        wall_integral(a / radius, edge) + wall_integral(b / radius, 0.5 * std::numbers::pi - edge);
    return sum / (2.0 * std::numbers::pi);
}

double corner_occlusion_at(const glm::dvec3& world, double radius) {
    std::array distances{std::abs(world.x), std::abs(world.y), std::abs(world.z)};
    std::ranges::sort(distances);
    return corner_occlusion(distances[1], distances[2], radius);
}

Scene make_corner() {
    constexpr double extent = 12.0;
    constexpr double cell = 1.0;
    const glm::dvec3 x{extent, 0, 0};
    const glm::dvec3 y{0, extent, 0};
    const glm::dvec3 z{0, 0, extent};
    Scene scene{.name = "corner",
                .mesh = colored(make_parallelogram({0, 0, 0}, z, x, cell), {0.8F, 0.8F, 0.8F})};
    append(scene.mesh, colored(make_parallelogram({0, 0, 0}, x, y, cell), {0.15F, 0.7F, 0.15F}));
    append(scene.mesh, colored(make_parallelogram({0, 0, 0}, y, z, cell), {0.8F, 0.1F, 0.1F}));
    scene.camera = {.eye = {3.6, 3.1, 3.9},
                    .target = {0.6, 0.6, 0.6},
                    .fovy_rad = 0.9,
                    .near = 0.1,
                    .far = 40.0,
                    .reversed_z = true};
    scene.ao_radius = 1.0;
    scene.lamp = glm::dvec3(2.2, 3.4, 3.0);
    return scene;
}

}  // namespace gloam::scene
