// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/sampling.hpp"

// Pixels, and what a camera makes of them.
namespace gloam::reference {

inline glm::ivec2 gloam_clamp_to_edge(glm::ivec2 pixel, glm::ivec2 size) {
    return clamp(pixel, glm::ivec2(0), max(size, 1) - 1);
}

inline glm::ivec2 gloam_guard_band_border(glm::ivec2 size, double guard) {
    return {glm::round(gloam_unit_interval(guard) * dvec2(max(size, 0)))};
}

inline dvec2 gloam_guard_band_guard(glm::ivec2 size, double guard) {
    return dvec2(gloam_guard_band_border(size, guard)) / dvec2(max(size, 1));
}

inline double gloam_guard_band_tan_half_fov(double tan_half_fov, double guard) {
    const double wider = (1.0 + 2.0 * guard) * tan_half_fov;
    return is_finite(wider) ? wider : 0.0;
}

inline int gloam_nearest_index(double u, int resolution) {
    if (std::isnan(u)) return 0;
    return int(clamp(floor(u * resolution), 0.0, max(resolution, 1) - 1.0));
}

inline glm::ivec2 gloam_nearest_pixel(dvec2 uv, glm::ivec2 resolution) {
    return {gloam_nearest_index(uv.x, resolution.x), gloam_nearest_index(uv.y, resolution.y)};
}

inline dvec2 gloam_pixel_center(dvec2 uv, glm::ivec2 resolution) {
    const glm::ivec2 size = max(resolution, 1);
    return (dvec2(gloam_nearest_pixel(uv, size)) + 0.5) / dvec2(size);
}

inline bool gloam_inside_unit(dvec2 uv) {
    return uv == clamp(uv, 0.0, 1.0);
}

// Within 1/256 of a texel's centre: that texel alone.
inline dvec2 gloam_texel_position(double u, int extent) {
    if (!(u >= 0.0 && u <= 1.0) || extent < 1) return dvec2(0.0);
    const double position = u * extent - 0.5;
    const double nearest = std::round(position);
    if (abs(position - nearest) < 1.0 / 256.0) return {nearest, 0.0};
    return {floor(position), fract(position)};
}

inline dvec2 gloam_ndc_from_pixel(glm::ivec2 pixel, glm::ivec2 size) {
    if (size.x < 1 || size.y < 1) return dvec2(0.0);
    return 2.0 * (dvec2(pixel) + 0.5) / dvec2(size) - 1.0;
}

inline dvec2 gloam_uv_from_ndc(dvec2 ndc) {
    return is_finite(ndc) ? ndc / 2.0 + 0.5 : dvec2(2.0);
}

inline dvec3 gloam_view_position_perspective(dvec2 ndc, double depth, dvec2 p00_p11) {
    const dvec3 position = depth * dvec3(ndc / p00_p11, -1.0);
    return gloam_is_background(depth) || !is_finite(position) ? dvec3(0.0) : position;
}

inline dvec3 gloam_view_position_orthographic(dvec2 ndc, double depth, dvec2 p00_p11) {
    const dvec3 position(ndc / p00_p11, -depth);
    return gloam_is_background(depth) || !is_finite(position) ? dvec3(0.0) : position;
}

inline dvec2 gloam_ndc_perspective(dvec3 view_position, dvec2 p00_p11) {
    const double depth = -view_position.z;
    const dvec2 ndc = p00_p11 * dvec2(view_position) / depth;
    return gloam_is_background(depth) || !is_finite(ndc) ? dvec2(2.0) : ndc;
}

inline dvec2 gloam_ndc_orthographic(dvec3 view_position, dvec2 p00_p11) {
    const dvec2 ndc = p00_p11 * dvec2(view_position);
    return gloam_is_background(-view_position.z) || !is_finite(ndc) ? dvec2(2.0) : ndc;
}

inline double gloam_positive_length(double x) {
    return std::isnan(x) ? 0.0 : std::clamp(x, 0.0, float_max);
}

inline dvec2 positive_lengths(dvec2 axes) {
    return {gloam_positive_length(axes.x), gloam_positive_length(axes.y)};
}

inline dvec2 gloam_projected_radius_uv_orthographic(double radius, double depth, dvec2 p00_p11) {
    if (gloam_is_background(depth)) return dvec2(0.0);
    return positive_lengths(gloam_positive_length(radius) * abs(p00_p11) / 2.0);
}

inline dvec2 gloam_projected_radius_uv(double radius, double depth, dvec2 p00_p11) {
    if (gloam_is_background(depth)) return dvec2(0.0);
    return positive_lengths(gloam_positive_length(radius) * abs(p00_p11) / (2.0 * depth));
}

inline dvec2 gloam_radius_cap(dvec2 axes, double most) {
    const dvec2 reach = positive_lengths(axes);
    const double larger = max(reach.x, reach.y);
    const double cap = gloam_positive_length(most);
    return larger > cap ? reach * (cap / larger) : reach;
}

inline double gloam_covering_radius_parallel(dvec3 position, double radius, double largest) {
    const double depth = -position.z;
    if (!is_finite(position) || gloam_is_background(depth) || !(radius > 0.0)) return 0.0;
    return min(radius / depth, gloam_positive_length(largest));
}

// R / (cos t (d - R sin t)), t the angle off the axis.
inline double gloam_covering_radius_perpendicular(dvec3 position, double radius, double largest) {
    const double depth = -position.z;
    if (!is_finite(position) || gloam_is_background(depth) || !(radius > 0.0)) return 0.0;
    const double t = atan(length(dvec2(position)) / depth);
    const double divisor = cos(t) * (depth - radius * sin(t));
    return divisor > 0.0 ? min(radius / divisor, gloam_positive_length(largest))
                         : gloam_positive_length(largest);
}

struct GloamCamera {
    dvec2 p00_p11;
    glm::ivec2 size;
    bool orthographic;
};

inline dvec2 gloam_camera_uv(dvec3 view_position, const GloamCamera& camera) {
    const auto ndc = camera.orthographic ? gloam_ndc_orthographic : gloam_ndc_perspective;
    return gloam_uv_from_ndc(ndc(view_position, camera.p00_p11));
}

inline dvec3 gloam_camera_position(glm::ivec2 pixel, double depth, const GloamCamera& camera) {
    const auto position =
        camera.orthographic ? gloam_view_position_orthographic : gloam_view_position_perspective;
    return position(gloam_ndc_from_pixel(pixel, camera.size), depth, camera.p00_p11);
}

inline dvec3 gloam_previous_view(glm::ivec2 pixel, double depth, const GloamCamera& camera,
                                 dmat4 previous_from_current) {
    return previous_from_current * dvec4(gloam_camera_position(pixel, depth, camera), 1.0);
}

// On the ray through where the point was in the image; a point that only the camera has moved has none.
inline dvec3 gloam_previous_moved(glm::ivec2 pixel, dvec2 motion, dvec3 still, const GloamCamera& camera) {
    const bool told = is_finite(motion) && max(abs(motion.x), abs(motion.y)) < 1e9;
    const dvec2 ndc = gloam_ndc_from_pixel(pixel, camera.size) - 2.0 * motion / dvec2(camera.size);
    const dvec3 on_ray(ndc / camera.p00_p11 * (camera.orthographic ? 1.0 : -still.z), still.z);
    const bool hidden = !told && gloam_inside_unit(gloam_camera_uv(still, camera));
    const bool behind = !camera.orthographic && gloam_is_background(-still.z);
    return hidden || behind || !is_finite(told ? on_ray : still) ? dvec3(0.0) : (told ? on_ray : still);
}

inline dvec2 gloam_camera_radius(double radius, double depth, const GloamCamera& camera) {
    const auto axes =
        camera.orthographic ? gloam_projected_radius_uv_orthographic : gloam_projected_radius_uv;
    return axes(radius, depth, camera.p00_p11);
}

inline double gloam_plane_depth(dvec2 ray, dvec3 point, dvec3 normal, bool orthographic) {
    const dvec3 origin = orthographic ? dvec3(ray, 0.0) : dvec3(0.0);
    const double facing = dot(normal, dvec3(ray, -1.0) - origin);
    const double t = dot(normal, point - origin) / facing;
    return facing < 0.0 && t > 0.0 && t <= float_max ? t : -point.z;
}

// fetch_depth: called for pixels inside the image only.
inline dvec3 gloam_camera_surface(glm::ivec2 pixel, const GloamCamera& camera,
                                  const Fetch<double>& fetch_depth) {
    if (!has_pixel(camera.size, pixel)) return dvec3(0.0);
    return gloam_camera_position(pixel, fetch_depth(pixel), camera);
}

inline dvec3 gloam_camera_normal(glm::ivec2 pixel, const GloamCamera& camera,
                                 const Fetch<double>& fetch_depth) {
    const auto position = [&](int x, int y) {
        const glm::ivec2 at = gloam_clamp_to_edge(pixel, camera.size) + glm::ivec2(x, y);
        return gloam_camera_surface(at, camera, fetch_depth);
    };
    const auto normal =
        camera.orthographic ? gloam_normal_from_neighbors_orthographic : gloam_normal_from_neighbors;
    return normal(position(0, 0), position(-1, 0), position(1, 0), position(0, -1), position(0, 1));
}

}  // namespace gloam::reference
