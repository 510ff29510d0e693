// SPDX-License-Identifier: MIT
#include "scene/mesh_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "scene/mesh.hpp"

namespace gloam::scene {
namespace {

constexpr double mesh_fovy_rad = 0.7;
constexpr double margin = 0.08;  // of the image, on each side
constexpr glm::vec3 ground_color(0.42F, 0.41F, 0.4F);

void check(const MeshView& view) {
    const auto refuse = [](const std::string& what) { throw std::invalid_argument("mesh view: " + what); };
    if (!(std::abs(view.elevation_deg) <= 89.0))
        refuse(fmt::format("elevation of {} degrees, expected -89 to 89", view.elevation_deg));
    if (!std::isfinite(view.azimuth_deg)) refuse("the azimuth is not finite");
    if (!(view.aspect > 0.0)) refuse(fmt::format("aspect {}, expected > 0", view.aspect));
}

// Rows of the rotation that turns the file's up axis into +y and maps axes to axes.
glm::dmat3 upright(const glm::dvec3& up) {
    const glm::dvec3 side = std::abs(up.x) > 0.5 ? glm::dvec3(0, -up.x, 0) : glm::dvec3(1, 0, 0);
    return glm::transpose(glm::dmat3(side, up, glm::cross(side, up)));
}

Mesh turned(Mesh mesh, const glm::dmat3& rotation) {
    for (glm::vec3& p : mesh.positions) p = rotation * glm::dvec3(p);
    for (glm::vec3& n : mesh.normals) n = rotation * glm::dvec3(n);
    return mesh;
}

glm::dvec3 direction_of(double azimuth_deg, double elevation_deg) {
    const double azimuth = azimuth_deg * std::numbers::pi / 180.0;
    const double elevation = elevation_deg * std::numbers::pi / 180.0;
    return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
            std::cos(azimuth) * std::cos(elevation)};
}

// Distance from `center`, in a direction, at which an eye sees all vertices inside the image.
double fitting_distance(const Mesh& mesh, const glm::dvec3& center, const glm::dvec3& back, double aspect) {
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back));
    const glm::dvec3 up = glm::cross(back, right);
    const double tan_y = std::tan(0.5 * mesh_fovy_rad) * (1.0 - 2.0 * margin);
    const double tan_x = tan_y * aspect;
    double distance = 0.0;
    for (const glm::vec3& vertex : mesh.positions) {
        const glm::dvec3 p = glm::dvec3(vertex) - center;
        const double aside =
            std::max(std::abs(glm::dot(p, right)) / tan_x, std::abs(glm::dot(p, up)) / tan_y);
        distance = std::max(distance, glm::dot(p, back) + aside);
    }
    return distance;
}

Camera camera_from(const glm::dvec3& eye, const glm::dvec3& target, double size) {
    const double distance = glm::distance(eye, target);
    if (!(distance > 0.0)) throw std::invalid_argument("mesh view: the eye is where it looks");
    return {.eye = eye,
            .target = target,
            .fovy_rad = mesh_fovy_rad,
            .near = 0.02 * distance,
            .far = 50.0 * (distance + size),
            .reversed_z = true};
}

// size: of the mesh's bounds.
void place_camera(Scene& scene, const MeshView& view, const glm::dvec3& middle, double size) {
    const glm::dvec3 target = view.look_at.value_or(middle);
    const glm::dvec3 first =
        view.eye ? *view.eye - target : direction_of(view.azimuth_deg, view.elevation_deg);
    const double azimuth = std::atan2(first.x, first.z) * 180.0 / std::numbers::pi;
    const double elevation = std::atan2(first.y, std::hypot(first.x, first.z)) * 180.0 / std::numbers::pi;
    const glm::dvec3 back = direction_of(azimuth, elevation);
    const double distance =
        view.eye ? glm::length(first) : fitting_distance(scene.mesh, target, back, view.aspect);
    scene.camera = camera_from(target + distance * back, target, size);
}

}  // namespace

std::optional<glm::dvec3> axis_named(std::string_view name) {
    constexpr std::array names{"x", "y", "z"};
    const double sign = name.starts_with('-') ? -1.0 : 1.0;
    if (sign < 0.0) name.remove_prefix(1);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 direction(0.0);
        direction[axis] = sign;
        if (name == names[static_cast<std::size_t>(axis)]) return direction;
    }
    return std::nullopt;
}

Scene mesh_scene(Mesh mesh, std::string name, const MeshView& view) {
    check(view);
    mesh = turned(std::move(mesh), upright(view.up));
    const Bounds bounds = bounds_of(mesh);
    const glm::dvec3 size = bounds.high - bounds.low;
    const double largest = std::max({size.x, size.y, size.z});
    if (!(largest > 0.0)) throw std::invalid_argument("mesh " + name + ": all its vertices are one point");
    // A flat mesh has nearly no height: its longest side becomes 1.
    const double scale = 1.0 / (size.y > 1e-3 * largest ? size.y : largest);
    const glm::dvec3 foot{0.5 * (bounds.low.x + bounds.high.x), bounds.low.y,
                          0.5 * (bounds.low.z + bounds.high.z)};
    Scene scene{.name = std::move(name), .mesh = placed(std::move(mesh), scale, -scale * foot)};
    const double radius = 0.5 * scale * glm::length(size);
    place_camera(scene, view, {0, 0.5 * scale * size.y, 0}, radius);
    if (view.ground)
        append(scene.mesh, colored(make_parallelogram({-60 * radius, 0, 60 * radius}, {120 * radius, 0, 0},
                                                      {0, 0, -120 * radius}, 1.5 * radius),
                                   ground_color));
    scene.ao_radius = 0.2;
    return scene;
}

}  // namespace gloam::scene
