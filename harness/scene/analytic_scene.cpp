// SPDX-License-Identifier: MIT
#include "scene/analytic_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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

}  // namespace gloam::scene
