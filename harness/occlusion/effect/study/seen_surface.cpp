// SPDX-License-Identifier: MIT
#include "effect/study/seen_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gloam::effect {

SeenSurface::SeenSurface(const scene::ClosedFormView& view, std::uint32_t pixels)
    : view_(&view), orthographic_(view.camera.projection == scene::Projection::orthographic) {
    half_ = orthographic_ ? 0.5 * view.camera.view_height : std::tan(0.5 * view.camera.fovy_rad);
    if (pixels > 0) pitch_ = 2.0 * half_ / pixels;
}

glm::dvec2 SeenSurface::snapped(const glm::dvec2& place) const {
    if (pitch_ == 0.0) return place;
    const double last = std::round((half_ - 0.5 * pitch_) / pitch_);
    return pitch_ * glm::clamp(glm::floor(place / pitch_ + 0.5), -last, last);
}

Seen SeenSurface::at(const glm::dvec2& place) const {
    const glm::dvec2 center = snapped(place);
    const glm::dvec3 origin(orthographic_ ? center : glm::dvec2(0.0), 0.0);
    const glm::dvec3 direction(orthographic_ ? glm::dvec2(0.0) : center, -1.0);
    Seen seen{.own_pixel = pitch_ > 0.0 && center == glm::dvec2(0.0)};
    const auto hit = view_->scene.first_hit(origin, direction);
    seen.background = !hit;
    seen.depth = hit ? hit->distance : std::numeric_limits<double>::infinity();
    if (!hit) return seen;
    seen.offset = origin + hit->distance * direction - view_->point;
    seen.normal = glm::dot(hit->normal, direction) > 0.0 ? -hit->normal : hit->normal;
    return seen;
}

SeenSurface::Compared SeenSurface::compared(const glm::dvec3& point) const {
    if (!(point.z < 0.0)) return {};
    const glm::dvec2 place = glm::dvec2(point) / (orthographic_ ? 1.0 : -point.z);
    const double buffer = at(place).depth;
    if (pitch_ == 0.0) return {-point.z, buffer};
    const glm::dvec3 origin(orthographic_ ? snapped(place) : glm::dvec2(0.0), 0.0);
    const glm::dvec3 ray(orthographic_ ? glm::dvec2(0.0) : snapped(place), -1.0);
    const double facing = glm::dot(normal(), ray);
    const double depth = glm::dot(normal(), point - origin) / facing;
    return {facing < 0.0 && depth > 0.0 ? depth : -point.z, buffer};
}

}  // namespace gloam::effect
