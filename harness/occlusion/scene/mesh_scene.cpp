// SPDX-License-Identifier: MIT
#include "scene/mesh_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "scene/mesh.hpp"

namespace gloam::scene {
namespace {

constexpr double margin = 0.08;  // of the image, on each side
constexpr glm::vec3 ground_color(0.42F, 0.41F, 0.4F);

// Rows of the rotation that turns the file's up axis into +y and maps axes to axes.
glm::dmat3 upright(const glm::dvec3& up) {
    const glm::dvec3 side = std::abs(up.x) > 0.5 ? glm::dvec3(0, -up.x, 0) : glm::dvec3(1, 0, 0);
    return glm::transpose(glm::dmat3(side, up, glm::cross(side, up)));
}

// The longest side in its place if that is nearly nothing.
double height_of(const Bounds& bounds) {
    const glm::dvec3 size = bounds.high - bounds.low;
    const double largest = std::max({size.x, size.y, size.z});
    return size.y > 1e-3 * largest ? size.y : largest;
}

glm::dvec3 direction_of(double azimuth_deg, double elevation_deg) {
    const double azimuth = azimuth_deg * std::numbers::pi / 180.0;
    const double elevation = elevation_deg * std::numbers::pi / 180.0;
    return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
            std::cos(azimuth) * std::cos(elevation)};
}

// Distance from `center`, in a direction, at which an eye sees all vertices inside the image.
double fitting_distance(const Mesh& mesh, const glm::dvec3& center, const glm::dvec3& back,
                        const MeshView& view) {
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back));
    const glm::dvec3 up = glm::cross(back, right);
    const double tan_y = std::tan(0.5 * glm::radians(view.fovy_deg)) * (1.0 - 2.0 * margin);
    const double tan_x = tan_y * view.aspect;
    double distance = 0.0;
    for (const glm::vec3& vertex : mesh.positions) {
        const glm::dvec3 p = glm::dvec3(vertex) - center;
        const double aside =
            std::max(std::abs(glm::dot(p, right)) / tan_x, std::abs(glm::dot(p, up)) / tan_y);
        distance = std::max(distance, glm::dot(p, back) + aside);
    }
    return distance;
}

// size: of the mesh's bounds.
void place_camera(Scene& scene, const MeshView& view, const glm::dvec3& middle, double size) {
    const glm::dvec3 target = view.look_at.value_or(middle);
    const glm::dvec3 first =
        view.eye ? *view.eye - target : direction_of(view.azimuth_deg, view.elevation_deg);
    const glm::dvec3 back = glm::normalize(first);
    const double distance = view.eye ? glm::length(first) : fitting_distance(scene.mesh, target, back, view);
    if (!(distance > 0.0)) throw std::invalid_argument("mesh view: the eye is where it looks");
    const glm::dvec3 eye = target + distance * back;
    const double from_eye = glm::distance(eye, target);
    scene.camera = {.eye = eye,
                    .target = target,
                    .fovy_rad = glm::radians(view.fovy_deg),
                    .near = 0.02 * from_eye,
                    .far = 50.0 * (from_eye + size),
                    .reversed_z = true};
}

}  // namespace

std::optional<glm::dvec3> axis_named(std::string_view name) {
    const double sign = name.starts_with('-') ? -1.0 : 1.0;
    if (sign < 0.0) name.remove_prefix(1);
    const std::size_t axis = std::string_view("xyz").find(name);
    if (name.size() != 1 || axis == std::string_view::npos) return std::nullopt;
    glm::dvec3 direction(0.0);
    direction[static_cast<int>(axis)] = sign;
    return direction;
}

Mesh standing(Mesh mesh, const glm::dvec3& up, std::optional<double> height) {
    mesh = placed(std::move(mesh), upright(up), {0, 0, 0});
    const Bounds bounds = bounds_of(mesh);
    const double scale = height ? *height / height_of(bounds) : 1.0;
    const glm::dvec3 foot{0.5 * (bounds.low.x + bounds.high.x), bounds.low.y,
                          0.5 * (bounds.low.z + bounds.high.z)};
    return placed(std::move(mesh), glm::dmat3(1), -scale * foot, scale);
}

Scene mesh_scene(Mesh mesh, std::string name, const MeshView& view) {
    if (!(std::abs(view.elevation_deg) <= 89.0))
        throw std::invalid_argument(
            fmt::format("mesh view: elevation of {} degrees, expected -89 to 89", view.elevation_deg));
    if (!(view.fovy_deg >= 1.0 && view.fovy_deg <= 170.0))
        throw std::invalid_argument(
            fmt::format("mesh view: angle of view of {} degrees, expected 1 to 170", view.fovy_deg));
    if (!(height_of(bounds_of(mesh)) > 0.0))
        throw std::invalid_argument("mesh " + name + ": all its vertices are one point");
    Scene scene{.name = std::move(name), .mesh = standing(std::move(mesh), view.up)};
    const Bounds bounds = bounds_of(scene.mesh);
    const glm::dvec3 size = bounds.high - bounds.low;
    const double radius = 0.5 * glm::length(size);
    if (!(radius < 1e36)) throw std::invalid_argument("mesh " + scene.name + ": larger than 1e36 units");
    place_camera(scene, view, {0, 0.5 * size.y, 0}, radius);
    if (view.ground)
        append(scene.mesh, colored(make_parallelogram({-60 * radius, 0, 60 * radius}, {120 * radius, 0, 0},
                                                      {0, 0, -120 * radius}, 1.5 * radius),
                                   ground_color));
    scene.ao_radius = static_cast<float>(0.2 * height_of(bounds));
    return scene;
}

}  // namespace gloam::scene
