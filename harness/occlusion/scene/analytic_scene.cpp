// SPDX-License-Identifier: MIT
#include "scene/analytic_scene.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace gloam::scene {
namespace {

// Real roots of a x^2 + 2 b x + c in ascending order; a may be 0.
std::vector<double> roots_of(double a, double b, double c) {
    if (a == 0.0) return b == 0.0 ? std::vector<double>{} : std::vector<double>{-0.5 * c / b};
    const double discriminant = b * b - a * c;
    if (discriminant < 0.0) return {};
    // This form avoids the difference of two nearly equal numbers.
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    if (q == 0.0) return {0.0};
    std::vector<double> roots{q / a, c / q};
    std::ranges::sort(roots);
    return roots;
}

std::optional<SurfaceHit> hit_of(const Quadric& surface, const glm::dvec3& origin,
                                 const glm::dvec3& direction) {
    const auto& [center, axis, along, round, level, square, limits] = surface;
    const glm::dvec3 o = origin - center;
    const double rise = glm::dot(direction, axis);
    const double start = glm::dot(o, axis);
    const double a = along * rise * rise + round * glm::dot(direction, direction);
    const double b = along * start * rise + round * glm::dot(o, direction) + 0.5 * level * rise;
    const double c = along * start * start + round * glm::dot(o, o) + level * start - square;
    for (const double t : roots_of(a, b, c)) {
        const glm::dvec3 at = origin + t * direction;
        const auto outside = [&](const HalfSpace& limit) {
            return glm::dot(at - limit.point, limit.normal) < 0.0;
        };
        if (!(t > 0.0) || std::ranges::any_of(limits, outside)) continue;
        const glm::dvec3 p = o + t * direction;
        const glm::dvec3 gradient = (along * glm::dot(p, axis) + 0.5 * level) * axis + round * p;
        const double length = glm::length(gradient);
        const glm::dvec3 normal = length > 0.0 ? gradient / length : axis;
        return SurfaceHit{t, glm::dot(normal, direction) > 0.0 ? -normal : normal};
    }
    return std::nullopt;
}

}  // namespace

Quadric plane_of(const HalfSpace& plane, std::vector<HalfSpace> limits) {
    return {.center = plane.point, .axis = plane.normal, .level = 1.0, .limits = std::move(limits)};
}

std::optional<SurfaceHit> first_hit(const std::vector<Quadric>& scene, const glm::dvec3& origin,
                                    const glm::dvec3& direction) {
    std::optional<SurfaceHit> nearest;
    for (const Quadric& surface : scene) {
        const auto found = hit_of(surface, origin, direction);
        if (found && (!nearest || found->distance < nearest->distance)) nearest = found;
    }
    return nearest;
}

namespace {

constexpr double pi = std::numbers::pi;
constexpr double quarter = 0.25 * pi;

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

double wall_occlusion(double c) {
    return corner_occlusion(c, 1.0, 1.0);
}

const Quadric ground = plane_of({});

Quadric wall(double x, std::vector<HalfSpace> limits = {}) {
    return plane_of({{x, 0, 0}, {-1, 0, 0}}, std::move(limits));
}

// A plane through the point that rises by 45 degrees towards x, or away from it.
Quadric slope(double side) {
    return plane_of({{0, 0, 0}, {-side * std::sin(quarter), 0, std::cos(quarter)}});
}

// A half of a level plane above, on the side of the blockers from x on; seen from above.
Quadric roof(double height, double x) {
    return plane_of({{0, 0, height}, {0, 0, 1}}, {{{x, 0, 0}, {1, 0, 0}}});
}

// A camera that looks at the point. tilt: radians from the normal to the eye's direction, away from the
// blockers. half_height: of the image, at the point's depth.
Camera looking(Projection projection, double tilt, double distance = 4.0, double half_height = 1.6) {
    constexpr double roll = 0.35;  // radians about the optical axis: no edge runs along the pixels
    const glm::dvec3 back{-std::sin(tilt), 0, std::cos(tilt)};
    const glm::dvec3 side{std::cos(tilt), 0, std::sin(tilt)};
    return {.eye = distance * back,
            .target = {0, 0, 0},
            .up = glm::cross(back, std::cos(roll) * side + std::sin(roll) * glm::dvec3(0, 1, 0)),
            .projection = projection,
            .fovy_rad = 2.0 * std::atan(half_height / distance),
            .view_height = 2.0 * half_height};
}

}  // namespace

std::vector<ClosedFormView> closed_form_views(Projection projection) {
    const bool orthographic = projection == Projection::orthographic;
    const auto tilted = [&](double tilt) { return looking(projection, tilt); };
    std::vector<ClosedFormView> all;
    for (const double degrees : {0.0, 30.0, 60.0})
        all.push_back({fmt::format("plane {:g}", degrees), {ground}, tilted(degrees * pi / 180.0)});
    for (const double x : {0.25, 0.5, 0.75})
        all.push_back({fmt::format("wall {:g}", x), {ground, wall(x)}, tilted(quarter), wall_occlusion(x)});
    // A floor under a ceiling at 0.5 R, seen from between them, 2 R away, where the floor is seen at an angle
    // of 7 degrees.
    const double between = std::hypot(2.0, 0.25);
    if (!orthographic)
        all.push_back({"ceiling",
                       {ground, plane_of({{0, 0, 0.5}, {0, 0, -1}})},
                       looking(projection, std::atan2(2.0, 0.25), between, between),
                       0.25});
    // A floor that rises by 45 degrees from the line through the point; a line between two such slopes; a
    // funnel that rises from the point all round; the inside of a sphere of radius R, whose orthographic view
    // starts at half the height: the upper half would hide the inside.
    const double half = std::sin(quarter) * std::sin(quarter);
    const Quadric funnel{.along = 1.0, .round = -half, .limits = {{}}};
    const Quadric sphere{.center = {0, 0, 1}, .round = 1.0, .square = 1.0};
    const double groove = 0.5 * (1.0 - std::cos(quarter));
    all.push_back({"groove", {ground, slope(1.0)}, tilted(0.0), groove, false});
    all.push_back({"valley", {ground, slope(1.0), slope(-1.0)}, tilted(0.0), 2.0 * groove, false});
    all.push_back({"pit", {funnel}, tilted(0.0), 0.5, false});
    all.push_back(
        {"sphere", {sphere}, looking(projection, 0.0, orthographic ? 1.0 : 1.9), 1.0 / 12.0, false});
    // A floor 0.5 R before a block 1.5 R high, seen from straight above; a floor under the edge of a plate
    // without thickness at 0.5 R.
    const Quadric side = wall(0.5, {{{0, 0, 1.5}, {0, 0, -1}}});
    all.push_back({"step", {ground, side, roof(1.5, 0.5)}, tilted(0.0), wall_occlusion(0.5)});
    all.push_back({"plate", {ground, roof(0.5, 0.0)}, tilted(pi / 6.0), 0.125});
    return all;
}

GBuffer draw(const ClosedFormView& view, std::uint32_t size) {
    GBuffer buffer{.extent = {size, size}, .border = gpu::Extent{size / 2, size / 2}};
    Camera camera = view.camera;
    const glm::dmat3 rotation = view_rotation(camera);
    const glm::dmat3 back = glm::transpose(rotation);
    camera.eye = {0, 0, 0};
    camera.target = {0, 0, -1};
    camera.up = {0, 1, 0};
    buffer.camera = make_frame(camera, 1.0);
    const PixelPositions positions(buffer);
    for (std::size_t i = 0; i < std::size_t{size} * size; ++i) {
        const auto [origin, direction] = positions.ray(i);
        const auto hit = first_hit(view.scene, view.camera.eye + back * origin, back * direction);
        buffer.depth.push_back(hit ? static_cast<float>(hit->distance)
                                   : std::numeric_limits<float>::infinity());
        buffer.normal.push_back(hit ? glm::vec3(rotation * hit->normal) : glm::vec3(0.0F));
    }
    const std::size_t middle = std::size_t{size} * (size / 2) + size / 2;
    buffer.normal[middle] = glm::vec3(rotation[2]);  // several surfaces meet there
    return buffer;
}

double corner_occlusion(double a, double b, double radius) {
    // The azimuth of the corner's edge, where the nearer wall changes; measured from the first wall's normal.
    const double edge = std::atan2(b, a);
    return (wall_integral(a / radius, edge) + wall_integral(b / radius, 0.5 * pi - edge)) / (2.0 * pi);
}

double corner_occlusion_at(const glm::dvec3& world, double radius) {
    std::array distances{std::abs(world.x), std::abs(world.y), std::abs(world.z)};
    std::ranges::sort(distances);
    return corner_occlusion(distances[1], distances[2], radius);
}

}  // namespace gloam::scene
