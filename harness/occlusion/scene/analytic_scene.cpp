// SPDX-License-Identifier: MIT
#include "scene/analytic_scene.hpp"

#include <fmt/format.h>
#include <algorithm>
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
constexpr double away = 4.0;        // of the eye from the point
constexpr double half_image = 1.6;  // from the point to the edge of the image, at its depth
constexpr double roll = 0.35;       // radians about the optical axis: no edge runs along the pixels

// A view in coordinates of its own, which start at the point: x towards the blockers, z along the normal.
struct Setup {
    std::string name;
    double occlusion = 0.0;
    std::vector<Quadric> scene{};
    double tilt = 0.0;  // radians from the normal to the eye's direction, away from the blockers
    bool flat = true;
    double distance = away;
    double half_height = half_image;  // of the image, at the point's depth
};

ClosedFormView view_of(const Setup& setup, Projection projection) {
    const glm::dvec3 back{-std::sin(setup.tilt), 0, std::cos(setup.tilt)};
    const glm::dvec3 side{std::cos(setup.tilt), 0, std::sin(setup.tilt)};
    const glm::dvec3 right = std::cos(roll) * side + std::sin(roll) * glm::dvec3(0, 1, 0);
    const glm::dvec3 up = glm::cross(back, right);
    const auto place = [&](glm::dvec3& point, glm::dvec3& direction) {
        const auto turned = [&](const glm::dvec3& v) -> glm::dvec3 {
            return {glm::dot(v, right), glm::dot(v, up), glm::dot(v, back)};
        };
        point = turned(point) - glm::dvec3(0, 0, setup.distance);
        direction = turned(direction);
    };
    ClosedFormView view{
        .name = setup.name, .scene = setup.scene, .occlusion = setup.occlusion, .flat = setup.flat};
    place(view.point, view.normal);
    for (Quadric& surface : view.scene) {
        place(surface.center, surface.axis);
        for (HalfSpace& limit : surface.limits) place(limit.point, limit.normal);
    }
    view.camera.projection = projection;
    view.camera.view_height = 2.0 * setup.half_height;
    view.camera.fovy_rad = 2.0 * std::atan(setup.half_height / setup.distance);
    return view;
}

double wall_occlusion(double c) {
    const double s = std::sqrt(1.0 - c * c);
    return 2.0 / pi * (0.5 * (std::acos(c) - c * s) - c * (std::acosh(1.0 / c) - s));
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

// A funnel that rises from the point all round.
Quadric funnel(double elevation) {
    const double sine = std::sin(elevation);
    return {.along = 1.0, .round = -sine * sine, .limits = {{}}};
}

// A floor under a ceiling at 0.5 R, seen from between them, 2 R away, where the floor is seen at an angle of
// 7 degrees.
Setup under_ceiling() {
    constexpr double height = 0.5;
    constexpr double along = 2.0;
    const double distance = std::hypot(along, 0.5 * height);
    return {.name = "ceiling",
            .occlusion = (1.0 - height) * (1.0 - height),
            .scene = {ground, plane_of({{0, 0, height}, {0, 0, -1}})},
            .tilt = std::atan2(along, 0.5 * height),
            .distance = distance,
            .half_height = distance};
}

std::vector<Setup> setups(bool orthographic) {
    std::vector<Setup> all;
    for (const double degrees : {0.0, 30.0, 60.0})
        all.push_back({fmt::format("plane {:g}", degrees), 0.0, {ground}, degrees * pi / 180.0});
    for (const double x : {0.25, 0.5, 0.75})
        all.push_back({fmt::format("wall {:g}", x), wall_occlusion(x), {ground, wall(x)}, quarter});
    if (!orthographic) all.push_back(under_ceiling());
    // A floor that rises by 45 degrees from the line through the point; a line between two such slopes; the
    // bottom of a funnel; the inside of a sphere of radius R.
    all.push_back({"groove", 0.5 * (1.0 - std::cos(quarter)), {ground, slope(1.0)}, 0.0, false});
    all.push_back({"valley", 1.0 - std::cos(quarter), {ground, slope(1.0), slope(-1.0)}, 0.0, false});
    all.push_back({"pit", 0.5, {funnel(quarter)}, 0.0, false});
    const Quadric sphere{.center = {0, 0, 1}, .round = 1.0, .square = 1.0};
    // The orthographic view of it starts at half the height: the upper half would hide the inside.
    all.push_back({"sphere", 1.0 / 12.0, {sphere}, 0.0, false, orthographic ? 1.0 : 1.9});
    // A floor 0.5 R before a block 1.5 R high, seen from straight above; a floor under the edge of a plate
    // without thickness at 0.5 R.
    const Quadric side = wall(0.5, {{{0, 0, 1.5}, {0, 0, -1}}});
    all.push_back({"step", wall_occlusion(0.5), {ground, side, roof(1.5, 0.5)}});
    all.push_back({"plate", 0.5 * 0.5 * 0.5, {ground, roof(0.5, 0.0)}, pi / 6.0});
    return all;
}

}  // namespace

std::vector<ClosedFormView> closed_form_views(Projection projection) {
    std::vector<ClosedFormView> views;
    for (const Setup& setup : setups(projection == Projection::orthographic))
        views.push_back(view_of(setup, projection));
    return views;
}

GBuffer draw(const ClosedFormView& view, std::uint32_t size) {
    GBuffer buffer{.extent = {size, size}, .border = gpu::Extent{size / 2, size / 2}};
    buffer.camera = make_frame(view.camera, 1.0);
    const PixelPositions positions(buffer);
    for (std::size_t i = 0; i < std::size_t{size} * size; ++i) {
        const auto [origin, direction] = positions.ray(i);
        const auto hit = first_hit(view.scene, origin, direction);
        buffer.depth.push_back(hit ? static_cast<float>(hit->distance)
                                   : std::numeric_limits<float>::infinity());
        buffer.normal.push_back(hit ? glm::vec3(hit->normal) : glm::vec3(0.0F));
    }
    const std::size_t middle = std::size_t{size} * (size / 2) + size / 2;
    buffer.normal[middle] = glm::vec3(view.normal);  // several surfaces meet there
    return buffer;
}

}  // namespace gloam::scene
