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

glm::dvec3 against(const glm::dvec3& normal, const glm::dvec3& direction) {
    return glm::dot(normal, direction) > 0.0 ? -normal : normal;
}

}  // namespace

void AnalyticScene::add_plane(const HalfSpace& plane, std::vector<HalfSpace> limits) {
    surfaces_.emplace_back(
        [plane, limits = std::move(limits)](const glm::dvec3& origin,
                                            const glm::dvec3& direction) -> std::optional<SurfaceHit> {
            const double t = glm::dot(plane.point - origin, plane.normal) / glm::dot(direction, plane.normal);
            if (!(t > 0.0 && std::isfinite(t))) return std::nullopt;
            const glm::dvec3 at = origin + t * direction;
            const auto outside = [&](const HalfSpace& limit) {
                return glm::dot(at - limit.point, limit.normal) < 0.0;
            };
            if (std::ranges::any_of(limits, outside)) return std::nullopt;
            return SurfaceHit{t, against(plane.normal, direction)};
        });
}

void AnalyticScene::add_sphere(const glm::dvec3& center, double radius) {
    surfaces_.emplace_back(
        [center, radius](const glm::dvec3& origin, const glm::dvec3& direction) -> std::optional<SurfaceHit> {
            const glm::dvec3 o = origin - center;
            const double a = glm::dot(direction, direction);
            for (const double t : roots_of(a, glm::dot(o, direction), glm::dot(o, o) - radius * radius))
                if (t > 0.0) return SurfaceHit{t, against((o + t * direction) / radius, direction)};
            return std::nullopt;
        });
}

// Solves ((x - apex) . axis)^2 = sin^2 |x - apex|^2 on the axis' side.
void AnalyticScene::add_cone(const glm::dvec3& apex, const glm::dvec3& axis, double elevation) {
    const double squared = std::sin(elevation) * std::sin(elevation);
    surfaces_.emplace_back([apex, axis, squared](const glm::dvec3& origin,
                                                 const glm::dvec3& direction) -> std::optional<SurfaceHit> {
        const glm::dvec3 o = origin - apex;
        const double rise = glm::dot(direction, axis);
        const double start = glm::dot(o, axis);
        const double a = rise * rise - squared * glm::dot(direction, direction);
        const double b = start * rise - squared * glm::dot(o, direction);
        const double c = start * start - squared * glm::dot(o, o);
        for (const double t : roots_of(a, b, c)) {
            const glm::dvec3 at = o + t * direction;
            const double height = glm::dot(at, axis);
            if (!(t > 0.0 && height >= 0.0)) continue;
            const glm::dvec3 gradient = height * axis - squared * at;
            const double length = glm::length(gradient);
            return SurfaceHit{t, against(length > 0.0 ? gradient / length : axis, direction)};
        }
        return std::nullopt;
    });
}

std::optional<SurfaceHit> AnalyticScene::first_hit(const glm::dvec3& origin,
                                                   const glm::dvec3& direction) const {
    std::optional<SurfaceHit> nearest;
    for (const Surface& surface : surfaces_) {
        const auto found = surface(origin, direction);
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

// A part of a plane: inside all of the limits.
struct Part {
    HalfSpace plane;
    std::vector<HalfSpace> limits{};
};

// A view in coordinates of its own, which start at the point: x towards the blockers, z along the normal.
struct Setup {
    std::string name;
    double occlusion = 0.0;
    double tilt = 0.0;  // radians from the normal to the eye's direction, away from the blockers
    double distance = away;
    double half_height = half_image;  // of the image, at the point's depth
    bool flat = true;
    std::vector<Part> planes{};
    double sphere = 0.0;  // > 0: one of this radius, that the point lies on
    double cone = 0.0;    // > 0: one of this elevation, whose apex the point is
};

ClosedFormView view_of(const Setup& setup, Projection projection) {
    const glm::dvec3 back{-std::sin(setup.tilt), 0, std::cos(setup.tilt)};
    const glm::dvec3 side{std::cos(setup.tilt), 0, std::sin(setup.tilt)};
    const glm::dvec3 right = std::cos(roll) * side + std::sin(roll) * glm::dvec3(0, 1, 0);
    const glm::dvec3 up = glm::cross(back, right);
    const auto turned = [&](const glm::dvec3& v) -> glm::dvec3 {
        return {glm::dot(v, right), glm::dot(v, up), glm::dot(v, back)};
    };
    const auto placed = [&](const HalfSpace& plane) -> HalfSpace {
        return {turned(plane.point) - glm::dvec3(0, 0, setup.distance), turned(plane.normal)};
    };
    const HalfSpace point = placed({{0, 0, 0}, {0, 0, 1}});
    ClosedFormView view{.name = setup.name,
                        .point = point.point,
                        .normal = point.normal,
                        .occlusion = setup.occlusion,
                        .flat = setup.flat};
    view.camera.projection = projection;
    view.camera.view_height = 2.0 * setup.half_height;
    view.camera.fovy_rad = 2.0 * std::atan(setup.half_height / setup.distance);
    for (const Part& part : setup.planes) {
        std::vector<HalfSpace> limits;
        for (const HalfSpace& limit : part.limits) limits.push_back(placed(limit));
        view.scene.add_plane(placed(part.plane), std::move(limits));
    }
    if (setup.sphere > 0.0) view.scene.add_sphere(view.point + view.normal, setup.sphere);
    if (setup.cone > 0.0) view.scene.add_cone(view.point, view.normal, setup.cone);
    return view;
}

double wall_occlusion(double c) {
    const double s = std::sqrt(1.0 - c * c);
    return 2.0 / pi * (0.5 * (std::acos(c) - c * s) - c * (std::acosh(1.0 / c) - s));
}

const Part ground{{{0, 0, 0}, {0, 0, 1}}};

Part wall(double x) {
    return {{{x, 0, 0}, {-1, 0, 0}}};
}

// A plane through the point that rises by 45 degrees towards x, or away from it.
Part slope(double side) {
    return {{{0, 0, 0}, {-side * std::sin(quarter), 0, std::cos(quarter)}}};
}

// A half of a level plane above, on the side of the blockers from x on; seen from above.
Part roof(double height, double x) {
    return {{{0, 0, height}, {0, 0, 1}}, {{{x, 0, 0}, {1, 0, 0}}}};
}

// From 2 R away, at half the height: the floor is seen at an angle of 7 degrees.
Setup under_ceiling() {
    constexpr double height = 0.5;
    constexpr double along = 2.0;
    const double distance = std::hypot(along, 0.5 * height);
    return {.name = "ceiling",  // floor under a ceiling at 0.5 R, seen from between them, 2 R away
            .occlusion = (1.0 - height) * (1.0 - height),
            .tilt = std::atan2(along, 0.5 * height),
            .distance = distance,
            .half_height = distance,
            .planes = {ground, {{{0, 0, height}, {0, 0, -1}}}}};
}

// All but planes, walls and the ceiling.
std::vector<Setup> shapes(Projection projection) {
    // The orthographic view of the sphere starts at half the height: the upper half would hide the inside.
    const bool orthographic = projection == Projection::orthographic;
    return {{.name = "groove",  // floor that rises by 45 degrees from the line through the point
             .occlusion = 0.5 * (1.0 - std::cos(quarter)),
             .flat = false,
             .planes = {ground, slope(1.0)}},
            {.name = "valley",  // line between two slopes of 45 degrees
             .occlusion = 1.0 - std::cos(quarter),
             .flat = false,
             .planes = {ground, slope(1.0), slope(-1.0)}},
            {.name = "pit",  // bottom of a funnel that rises by 45 degrees all round
             .occlusion = 0.5,
             .flat = false,
             .cone = quarter},
            {.name = "sphere",  // inside of a sphere of radius R
             .occlusion = 1.0 / 12.0,
             .distance = orthographic ? 1.0 : 1.9,
             .flat = false,
             .sphere = 1.0},
            {.name = "step",  // floor 0.5 R before a block 1.5 R high, seen from straight above
             .occlusion = wall_occlusion(0.5),
             .planes = {ground, {wall(0.5).plane, {{{0, 0, 1.5}, {0, 0, -1}}}}, roof(1.5, 0.5)}},
            {.name = "plate",  // floor under the edge of a plate without thickness at 0.5 R
             .occlusion = 0.5 * 0.5 * 0.5,
             .tilt = pi / 6.0,
             .planes = {ground, roof(0.5, 0.0)}}};
}

}  // namespace

std::vector<ClosedFormView> closed_form_views(Projection projection) {
    std::vector<ClosedFormView> views;
    const auto add = [&](const Setup& setup) { views.push_back(view_of(setup, projection)); };
    for (const double degrees : {0.0, 30.0, 60.0})
        add({.name = fmt::format("plane {:g}", degrees), .tilt = degrees * pi / 180.0, .planes = {ground}});
    for (const double distance : {0.25, 0.5, 0.75})
        add({.name = fmt::format("wall {:g}", distance),
             .occlusion = wall_occlusion(distance),
             .tilt = quarter,
             .planes = {ground, wall(distance)}});
    if (projection == Projection::perspective) add(under_ceiling());
    for (const Setup& setup : shapes(projection)) add(setup);
    return views;
}

GBuffer draw(const ClosedFormView& view, std::uint32_t size) {
    GBuffer buffer{.extent = {size, size}, .border = gpu::Extent{size / 2, size / 2}};
    buffer.camera = make_frame(view.camera, 1.0);
    const PixelPositions positions(buffer);
    for (std::size_t i = 0; i < std::size_t{size} * size; ++i) {
        const auto [origin, direction] = positions.ray(i);
        const auto hit = view.scene.first_hit(origin, direction);
        buffer.depth.push_back(hit ? static_cast<float>(hit->distance)
                                   : std::numeric_limits<float>::infinity());
        buffer.normal.push_back(hit ? glm::vec3(hit->normal) : glm::vec3(0.0F));
    }
    const std::size_t middle = std::size_t{size} * (size / 2) + size / 2;
    buffer.normal[middle] = glm::vec3(view.normal);  // several surfaces meet there
    return buffer;
}

}  // namespace gloam::scene
