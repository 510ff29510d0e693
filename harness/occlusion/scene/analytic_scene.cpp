// SPDX-License-Identifier: MIT
#include "scene/analytic_scene.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
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
    surfaces_.emplace_back(Plane{plane, std::move(limits)});
}

void AnalyticScene::add_sphere(const glm::dvec3& center, double radius) {
    surfaces_.emplace_back(Sphere{center, radius});
}

void AnalyticScene::add_cone(const glm::dvec3& apex, const glm::dvec3& axis, double elevation) {
    surfaces_.emplace_back(Cone{apex, axis, std::sin(elevation)});
}

std::optional<SurfaceHit> AnalyticScene::first_hit(const glm::dvec3& origin,
                                                   const glm::dvec3& direction) const {
    std::optional<SurfaceHit> nearest;
    for (const auto& surface : surfaces_) {
        const auto found = std::visit([&](const auto& s) { return hit(s, origin, direction); }, surface);
        if (found && (!nearest || found->distance < nearest->distance)) nearest = found;
    }
    return nearest;
}

std::optional<SurfaceHit> AnalyticScene::hit(const Plane& plane, const glm::dvec3& origin,
                                             const glm::dvec3& direction) {
    const glm::dvec3& n = plane.plane.normal;
    const double t = glm::dot(plane.plane.point - origin, n) / glm::dot(direction, n);
    if (!(t > 0.0 && std::isfinite(t))) return std::nullopt;
    const glm::dvec3 at = origin + t * direction;
    const auto outside = [&](const HalfSpace& limit) {
        return glm::dot(at - limit.point, limit.normal) < 0.0;
    };
    if (std::ranges::any_of(plane.limits, outside)) return std::nullopt;
    return SurfaceHit{t, against(n, direction)};
}

std::optional<SurfaceHit> AnalyticScene::hit(const Sphere& sphere, const glm::dvec3& origin,
                                             const glm::dvec3& direction) {
    const glm::dvec3 o = origin - sphere.center;
    const double a = glm::dot(direction, direction);
    for (const double t :
         roots_of(a, glm::dot(o, direction), glm::dot(o, o) - sphere.radius * sphere.radius)) {
        if (t > 0.0) return SurfaceHit{t, against((o + t * direction) / sphere.radius, direction)};
    }
    return std::nullopt;
}

// Solves ((x - apex) . axis)^2 = sin^2 |x - apex|^2 on the axis' side.
std::optional<SurfaceHit> AnalyticScene::hit(const Cone& cone, const glm::dvec3& origin,
                                             const glm::dvec3& direction) {
    const glm::dvec3 o = origin - cone.apex;
    const double squared = cone.sine * cone.sine;
    const double rise = glm::dot(direction, cone.axis);
    const double start = glm::dot(o, cone.axis);
    const double a = rise * rise - squared * glm::dot(direction, direction);
    const double b = start * rise - squared * glm::dot(o, direction);
    const double c = start * start - squared * glm::dot(o, o);
    for (const double t : roots_of(a, b, c)) {
        const glm::dvec3 at = o + t * direction;
        const double height = glm::dot(at, cone.axis);
        if (!(t > 0.0 && height >= 0.0)) continue;
        const glm::dvec3 gradient = height * cone.axis - squared * at;
        const double length = glm::length(gradient);
        return SurfaceHit{t, against(length > 0.0 ? gradient / length : cone.axis, direction)};
    }
    return std::nullopt;
}

namespace {

constexpr double pi = std::numbers::pi;
constexpr double quarter = 0.25 * pi;
constexpr double away = 4.0;        // of the eye from the point
constexpr double half_image = 1.6;  // from the point to the edge of the image, at its depth
constexpr double roll = 0.35;       // radians about the optical axis: no edge runs along the pixels

// Places a scene in front of the camera. The scene's coordinates start at the point; x points towards the
// blockers, z along the normal.
class Placement {
  public:
    // tilt: radians from the normal to the eye's direction, away from the blockers.
    Placement(double tilt, double distance) : distance_(distance) {
        const glm::dvec3 eye{-std::sin(tilt), 0, std::cos(tilt)};
        const glm::dvec3 side{std::cos(tilt), 0, std::sin(tilt)};
        const glm::dvec3 across{0, 1, 0};
        right_ = std::cos(roll) * side + std::sin(roll) * across;
        up_ = glm::cross(eye, right_);
        back_ = eye;
    }

    [[nodiscard]] glm::dvec3 turned(const glm::dvec3& v) const {
        return {glm::dot(v, right_), glm::dot(v, up_), glm::dot(v, back_)};
    }
    [[nodiscard]] glm::dvec3 placed(const glm::dvec3& at) const {
        return turned(at) - glm::dvec3(0, 0, distance_);
    }
    [[nodiscard]] HalfSpace half_space(const glm::dvec3& at, const glm::dvec3& normal) const {
        return {placed(at), turned(normal)};
    }

  private:
    double distance_;
    glm::dvec3 right_;
    glm::dvec3 up_;
    glm::dvec3 back_;
};

// All parts of a view except its surfaces.
struct Setup {
    std::string name;
    std::string description;
    double occlusion = 0.0;
    double tilt = 0.0;
    double distance = away;
    double half_height = half_image;  // of the image, at the point's depth
    bool seen_whole = true;
    bool flat = true;
};

ClosedFormView view_of(const Setup& setup, Projection projection) {
    const Placement place(setup.tilt, setup.distance);
    ClosedFormView view{.name = setup.name,
                        .description = setup.description,
                        .point = place.placed({0, 0, 0}),
                        .normal = place.turned({0, 0, 1}),
                        .occlusion = setup.occlusion,
                        .seen_whole = setup.seen_whole,
                        .flat = setup.flat};
    view.camera.projection = projection;
    view.camera.view_height = 2.0 * setup.half_height;
    view.camera.fovy_rad = 2.0 * std::atan(setup.half_height / setup.distance);
    return view;
}

// A view of the floor and of the surfaces that `add` adds.
template <class Add>
ClosedFormView on_floor(const Setup& setup, Projection projection, const Add& add) {
    ClosedFormView view = view_of(setup, projection);
    const Placement place(setup.tilt, setup.distance);
    view.scene.add_plane(place.half_space({0, 0, 0}, {0, 0, 1}));
    add(view.scene, place);
    return view;
}

ClosedFormView plane(double degrees, Projection projection) {
    return on_floor({.name = fmt::format("plane {:g}", degrees),
                     .description = fmt::format("bare plane, tilted by {:g} degrees", degrees),
                     .tilt = degrees * pi / 180.0},
                    projection, [](AnalyticScene&, const Placement&) {});
}

double wall_occlusion(double c) {
    const double s = std::sqrt(1.0 - c * c);
    return 2.0 / pi * (0.5 * (std::acos(c) - c * s) - c * (std::acosh(1.0 / c) - s));
}

ClosedFormView wall(double distance, Projection projection) {
    return on_floor(
        {.name = fmt::format("wall {:g}", distance),
         .description = fmt::format("floor {:g} R before a wall, both seen at 45 degrees", distance),
         .occlusion = wall_occlusion(distance),
         .tilt = quarter},
        projection, [&](AnalyticScene& scene, const Placement& place) {
            scene.add_plane(place.half_space({distance, 0, 0}, {-1, 0, 0}));
        });
}

// From 2 R away, at half the height: the floor is seen at an angle of 7 degrees.
ClosedFormView ceiling(Projection projection) {
    constexpr double height = 0.5;
    constexpr double along = 2.0;
    const double distance = std::hypot(along, 0.5 * height);
    return on_floor({.name = "ceiling",
                     .description = "floor under a ceiling at 0.5 R, seen from between them, 2 R away",
                     .occlusion = (1.0 - height) * (1.0 - height),
                     .tilt = std::atan2(along, 0.5 * height),
                     .distance = distance,
                     .half_height = distance},
                    projection, [&](AnalyticScene& scene, const Placement& place) {
                        scene.add_plane(place.half_space({0, 0, height}, {0, 0, -1}));
                    });
}

void add_slope(AnalyticScene& scene, const Placement& place, double side) {
    scene.add_plane(place.half_space({0, 0, 0}, {-side * std::sin(quarter), 0, std::cos(quarter)}));
}

ClosedFormView groove(Projection projection) {
    return on_floor({.name = "groove",
                     .description = "floor that rises by 45 degrees from the line through the point",
                     .occlusion = 0.5 * (1.0 - std::cos(quarter)),
                     .flat = false},
                    projection,
                    [](AnalyticScene& scene, const Placement& place) { add_slope(scene, place, 1.0); });
}

ClosedFormView valley(Projection projection) {
    return on_floor({.name = "valley",
                     .description = "line between two slopes of 45 degrees",
                     .occlusion = 1.0 - std::cos(quarter),
                     .flat = false},
                    projection, [](AnalyticScene& scene, const Placement& place) {
                        add_slope(scene, place, 1.0);
                        add_slope(scene, place, -1.0);
                    });
}

ClosedFormView pit(Projection projection) {
    const Setup setup{.name = "pit",
                      .description = "bottom of a funnel that rises by 45 degrees all round",
                      .occlusion = 0.5,
                      .flat = false};
    ClosedFormView view = view_of(setup, projection);
    view.scene.add_cone(view.point, view.normal, quarter);
    return view;
}

// The orthographic view starts at half the height, because the upper half would hide the inside.
ClosedFormView sphere(Projection projection) {
    const bool orthographic = projection == Projection::orthographic;
    const Setup setup{.name = "sphere",
                      .description = "inside of a sphere of radius R",
                      .occlusion = 1.0 / 12.0,
                      .distance = orthographic ? 1.0 : 1.9,
                      .half_height = half_image,
                      .flat = false};
    ClosedFormView view = view_of(setup, projection);
    view.scene.add_sphere(view.point + view.normal, 1.0);
    return view;
}

ClosedFormView step(Projection projection) {
    constexpr double at = 0.5;
    constexpr double height = 1.5;
    return on_floor({.name = "step",
                     .description = "floor 0.5 R before a block 1.5 R high, seen from straight above",
                     .occlusion = wall_occlusion(at)},
                    projection, [&](AnalyticScene& scene, const Placement& place) {
                        scene.add_plane(place.half_space({at, 0, 0}, {-1, 0, 0}),
                                        {place.half_space({0, 0, height}, {0, 0, -1})});
                        scene.add_plane(place.half_space({0, 0, height}, {0, 0, 1}),
                                        {place.half_space({at, 0, 0}, {1, 0, 0})});
                    });
}

ClosedFormView plate(Projection projection) {
    constexpr double height = 0.5;
    return on_floor({.name = "plate",
                     .description = "floor under the edge of a plate without thickness at 0.5 R",
                     .occlusion = 0.5 * (1.0 - height) * (1.0 - height),
                     .tilt = pi / 6.0,
                     .seen_whole = false},
                    projection, [&](AnalyticScene& scene, const Placement& place) {
                        scene.add_plane(place.half_space({0, 0, height}, {0, 0, 1}),
                                        {place.half_space({0, 0, 0}, {1, 0, 0})});
                    });
}

}  // namespace

std::vector<ClosedFormView> closed_form_views(Projection projection) {
    std::vector<ClosedFormView> views{plane(0, projection),   plane(30, projection), plane(60, projection),
                                      wall(0.25, projection), wall(0.5, projection), wall(0.75, projection),
                                      groove(projection),     valley(projection),    pit(projection),
                                      sphere(projection),     step(projection),      plate(projection)};
    if (projection == Projection::perspective) views.insert(views.begin() + 6, ceiling(projection));
    return views;
}

GBuffer draw(const ClosedFormView& view, std::uint32_t size) {
    if (size < 3 || size % 2 == 0)
        throw std::invalid_argument(
            fmt::format("view {}: {} pixels, expected an odd number from 3 on", view.name, size));
    GBuffer buffer{.extent = {size, size}, .border = gpu::Extent{size / 2, size / 2}};
    buffer.camera = make_frame(view.camera, 1.0);
    const glm::dvec2 scale(buffer.camera.p00_p11());
    const bool orthographic = buffer.camera.orthographic();
    for (std::uint32_t y = 0; y < size; ++y) {
        for (std::uint32_t x = 0; x < size; ++x) {
            const glm::dvec2 ndc = (2.0 * glm::dvec2(x, y) + 1.0) / static_cast<double>(size) - 1.0;
            const glm::dvec3 place(ndc / scale, orthographic ? 0.0 : -1.0);
            const auto hit = orthographic ? view.scene.first_hit(place, {0, 0, -1})
                                          : view.scene.first_hit({0, 0, 0}, place);
            buffer.depth.push_back(hit ? static_cast<float>(hit->distance)
                                       : std::numeric_limits<float>::infinity());
            buffer.normal.push_back(hit ? glm::vec3(hit->normal) : glm::vec3(0.0F));
        }
    }
    const std::size_t middle = std::size_t{size} * (size / 2) + size / 2;
    buffer.normal[middle] = glm::vec3(view.normal);  // several surfaces meet there
    return buffer;
}

}  // namespace gloam::scene
