// SPDX-License-Identifier: MIT
#include "stress/views.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gloam::stress {
namespace {

constexpr float wall_depth = 3.0F;
constexpr float step_height = 0.25F;

}  // namespace

scene::GBuffer plane(gpu::Extent extent) {
    scene::GBuffer view{.extent = extent};
    const std::size_t pixels = std::size_t{extent.width} * extent.height;
    view.depth.assign(pixels, wall_depth);
    view.normal.assign(pixels, glm::vec3(0.0F, 0.0F, 1.0F));
    view.camera =
        scene::make_frame({}, static_cast<double>(extent.width) / static_cast<double>(extent.height));
    return view;
}

scene::GBuffer steps(gpu::Extent extent) {
    scene::GBuffer view = plane(extent);
    for (std::size_t i = 0; i < view.depth.size(); ++i) {
        const std::size_t field = (i % extent.width) / 6 + (i / extent.width) / 5;
        if (field % 2 == 1) view.depth[i] -= step_height;
    }
    return view;
}

const std::vector<float>& bad_values() {
    using Limits = std::numeric_limits<float>;
    constexpr float largest_subnormal = 1.17549421e-38F;
    static const std::vector<float> all{Limits::quiet_NaN(),
                                        -Limits::quiet_NaN(),
                                        Limits::infinity(),
                                        -Limits::infinity(),
                                        0.0F,
                                        -0.0F,
                                        -1.0F,
                                        Limits::denorm_min(),
                                        largest_subnormal,
                                        Limits::min(),
                                        1e-20F,
                                        1e20F,
                                        -1e20F,
                                        Limits::max(),
                                        Limits::lowest()};
    return all;
}

std::size_t outside_unit(const std::vector<float>& values) {
    return static_cast<std::size_t>(
        std::ranges::count_if(values, [](float v) { return !(v >= 0.0F && v <= 1.0F); }));
}

namespace {

std::size_t index_of(glm::ivec2 pixel, gpu::Extent extent) {
    return static_cast<std::size_t>(pixel.y) * extent.width + static_cast<std::size_t>(pixel.x);
}

glm::ivec2 pixel_at(std::size_t index, gpu::Extent extent) {
    return {static_cast<int>(index % extent.width), static_cast<int>(index / extent.width)};
}

// Where a circle around (slope * depth, depth) begins and ends as seen from the origin, as slopes.
glm::dvec2 seen_slopes(double slope, double depth, double radius) {
    const double distance = std::hypot(slope * depth, depth);
    const double half = radius < distance ? std::asin(radius / distance) : INFINITY;
    const double angle = std::atan(slope);
    constexpr double right_angle = 1.57079632679489661923;
    return {angle - half > -right_angle ? std::tan(angle - half) : -INFINITY,
            angle + half < right_angle ? std::tan(angle + half) : INFINITY};
}

// Whether the ball around a pixel's surface point, and a pixel and a half more, covers the centre of
// `source`.
bool covers(const scene::GBuffer& view, glm::ivec2 pixel, double depth, double radius, glm::ivec2 source) {
    const glm::dvec2 size(view.extent.width, view.extent.height);
    const glm::dvec2 p = glm::abs(glm::dvec2(view.camera.p00_p11()));
    for (int axis = 0; axis < 2; ++axis) {
        const double slope = (2.0 * (pixel[axis] + 0.5) / size[axis] - 1.0) / p[axis];
        const glm::dvec2 ends = seen_slopes(slope, depth, radius);
        const glm::dvec2 pixels = 0.5 * (ends * p[axis] + 1.0) * size[axis];
        const double at = source[axis] + 0.5;
        if (!(at >= pixels.x - 1.5 && at <= pixels.y + 1.5)) return false;
    }
    return true;
}

}  // namespace

Mask depth_footprint(const scene::GBuffer& view, double radius, glm::ivec2 source) {
    Mask mask(view.depth.size());
    for (std::size_t i = 0; i < mask.size(); ++i)
        mask[i] = covers(view, pixel_at(i, view.extent), double{view.depth[i]}, radius, source);
    mask[index_of(source, view.extent)] = true;
    return mask;
}

Mask single_pixel(gpu::Extent extent, glm::ivec2 source) {
    Mask mask(std::size_t{extent.width} * extent.height);
    mask[index_of(source, extent)] = true;
    return mask;
}

Mask widened(const Mask& mask, gpu::Extent extent, int pixels) {
    Mask wide(mask.size());
    const glm::ivec2 last(static_cast<int>(extent.width) - 1, static_cast<int>(extent.height) - 1);
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (!mask[i]) continue;
        const glm::ivec2 low = glm::max(pixel_at(i, extent) - pixels, glm::ivec2(0));
        const glm::ivec2 high = glm::min(pixel_at(i, extent) + pixels, last);
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) wide[index_of({x, y}, extent)] = true;
    }
    return wide;
}

int reach_of(const Mask& mask, gpu::Extent extent, glm::ivec2 source) {
    int reach = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (!mask[i]) continue;
        const glm::ivec2 away = glm::abs(pixel_at(i, extent) - source);
        reach = std::max({reach, away.x, away.y});
    }
    return reach;
}

}  // namespace gloam::stress
