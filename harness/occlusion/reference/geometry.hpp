// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/numeric.hpp"

// Vectors, depths, normals, slices, and how a surface bends and spreads.
namespace gloam::reference {

inline bool gloam_is_finite(double x) {
    return is_finite(x);
}

inline bool gloam_is_nan(double x) {
    return std::isnan(x);
}

inline bool gloam_is_finite2(dvec2 v) {
    return is_finite(v);
}

inline bool gloam_is_finite3(dvec3 v) {
    return is_finite(v);
}

inline bool gloam_is_finite4(dvec4 v) {
    return is_finite(v);
}

inline double gloam_background_depth() {
    return infinity;
}

inline bool gloam_is_background(double depth) {
    return !(depth >= float_min && depth <= float_max);
}

// Whether a vector is finite and not zero; a subnormal component counts as zero.
inline bool has_direction(dvec3 v) {
    return is_finite(v) && std::max({abs(v.x), abs(v.y), abs(v.z)}) >= float_min;
}

inline double gloam_length(dvec3 v) {
    return has_direction(v) ? length(v) : 0.0;
}

inline dvec3 gloam_safe_normalize(dvec3 v, dvec3 fallback) {
    return has_direction(v) ? v / length(v) : fallback;
}

inline double gloam_height_at(dvec3 offset, dvec3 aim, dvec3 normal, double facing) {
    return dot(offset - aim, normal) / facing;
}

inline double gloam_depth_quotient(double numerator, double denominator) {
    const bool divides = abs(denominator) >= float_min && abs(denominator) <= 0x1p126;
    return divides && !gloam_is_background(numerator / denominator) ? numerator / denominator : infinity;
}

inline double gloam_linear_depth_perspective_vk(double b, double p22, double p32) {
    return gloam_depth_quotient(p32, b + p22);
}

inline double gloam_linear_depth_perspective_gl(double b, double p22, double p32) {
    return gloam_depth_quotient(p32, 2.0 * b + (p22 - 1.0));
}

inline double gloam_linear_depth_orthographic_vk(double b, double p22, double p32) {
    return gloam_depth_quotient(p32 - b, p22);
}

inline double gloam_linear_depth_orthographic_gl(double b, double p22, double p32) {
    return gloam_depth_quotient(p32 + 1.0 - 2.0 * b, p22);
}

inline dvec3 gloam_neighbor_direction(dvec3 center, dvec3 behind, dvec3 ahead) {
    dvec3 flattest(0.0);
    double least = infinity;
    for (const auto& [neighbor, step] : {std::pair(ahead, ahead - center), {behind, center - behind}}) {
        if (gloam_is_background(-neighbor.z) || !(abs(step.z) < least)) continue;
        least = abs(step.z);
        flattest = step;
    }
    return gloam_safe_normalize(flattest, dvec3(0.0));
}

inline dvec3 gloam_facing_normal(dvec3 along_x, dvec3 along_y, dvec3 toward_viewer) {
    const dvec3 span = cross(along_x, along_y);
    if (!(length(span) >= 1e-5 && length(span) <= 2.0)) return {0.0, 0.0, 1.0};
    return (dot(span, toward_viewer) < 0.0 ? -1.0 : 1.0) * normalize(span);
}

inline dvec3 gloam_normal_from_neighbors(dvec3 center, dvec3 left, dvec3 right, dvec3 up, dvec3 down) {
    if (gloam_is_background(-center.z)) return dvec3(0.0);
    return gloam_facing_normal(gloam_neighbor_direction(center, left, right),
                               gloam_neighbor_direction(center, down, up), -center);
}

inline dvec3 gloam_normal_from_neighbors_orthographic(dvec3 center, dvec3 left, dvec3 right, dvec3 up,
                                                      dvec3 down) {
    if (gloam_is_background(-center.z)) return dvec3(0.0);
    return gloam_facing_normal(gloam_neighbor_direction(center, left, right),
                               gloam_neighbor_direction(center, down, up), dvec3(0.0, 0.0, 1.0));
}

// u of the tangent plane with u . axis = 1; the axis itself where the slice is within 2 degrees of that
// plane.
inline dvec3 along_tangent_plane(dvec3 axis, dvec3 normal) {
    const double cosine = dot(axis, normal);
    const double sine_squared = 1.0 - cosine * cosine;
    return sine_squared > 1e-3 ? (axis - cosine * normal) / sine_squared : axis;
}

inline dvec3 gloam_into_slice(dvec3 offset, dvec3 axis, dvec3 normal) {
    const dvec3 moved = offset - dot(offset, axis) * along_tangent_plane(axis, normal);
    return is_finite(moved) ? moved : dvec3(0.0);
}

struct GloamSlice {
    dvec3 view;
    dvec3 tangent;
    dvec2 normal;
    double angle;
    double weight;
};

// The normal's part in the plane of the view vector and the direction, by its length and its angle.
inline GloamSlice gloam_slice(dvec2 direction, dvec3 view, dvec3 normal) {
    const dvec3 along(direction, 0.0);
    const dvec3 tangent = gloam_safe_normalize(along - dot(along, view) * view, dvec3(0.0));
    const dvec2 part(dot(normal, view), dot(normal, tangent));
    const double weight = length(part);
    if (!(weight >= float_min && tangent != dvec3(0.0)))
        return {dvec3(0.0, 0.0, 1.0), tangent, {1.0, 0.0}, 0.0, 0.0};
    const dvec3 ahead = gloam_safe_normalize({max(part.x, 0.0), part.y, 0.0}, {0.0, 1.0, 0.0});
    const double angle = std::atan2(ahead.y, ahead.x);
    return {view, tangent, on_circle(angle), angle, min(weight, 1.0)};
}

inline double gloam_slice_whole(const GloamSlice& slice) {
    return cos(slice.angle) + slice.angle * sin(slice.angle);
}

struct GloamSliceAxes {
    dvec3 view;
    dvec3 tangent;
};

// Such that offset . axes = gloam_into_slice(offset) . slice.
inline GloamSliceAxes gloam_slice_axes(const GloamSlice& slice, dvec3 normal) {
    const dvec3 axis = cross(slice.tangent, slice.view);
    const dvec3 across = along_tangent_plane(axis, normal);
    return {slice.view - dot(across, slice.view) * axis, slice.tangent - dot(across, slice.tangent) * axis};
}

// H + (H^2 - K)^(1/2) and H - (H^2 - K)^(1/2) of the mean and the Gaussian curvature, from the first and
// second fundamental forms (e f; f g) and (l m; m n).
inline dvec2 gloam_principal_curvatures(dvec3 position_x, dvec3 position_y, dvec3 normal_x, dvec3 normal_y) {
    const double e = dot(position_x, position_x);
    const double f = dot(position_x, position_y);
    const double g = dot(position_y, position_y);
    const double area = e * g - f * f;
    if (!(e >= 1e-18 && g >= 1e-18 && e <= 1e18 && g <= 1e18 && area > 1e-8 * e * g)) return dvec2(0.0);
    const double l = -dot(position_x, normal_x);
    const double m = -(dot(position_x, normal_y) + dot(position_y, normal_x)) / 2.0;
    const double n = -dot(position_y, normal_y);
    const double mean = (e * n - 2.0 * f * m + g * l) / (2.0 * area);
    const double gaussian = (l * n - m * m) / area;
    const double spread = sqrt(max(mean * mean - gaussian, 0.0));
    const dvec2 curvatures(mean + spread, mean - spread);
    return is_finite(curvatures) ? curvatures : dvec2(0.0);
}

struct GloamSurfaceMoments {
    double weight;
    dvec3 mean;
    dvec3 variance;
    dvec3 covariance;  // yz, zx, xy
};

inline GloamSurfaceMoments gloam_moments_empty() {
    return {0.0, dvec3(0.0), dvec3(0.0), dvec3(0.0)};
}

inline GloamSurfaceMoments gloam_moments_of(dvec3 point) {
    return {1.0, point, dvec3(0.0), dvec3(0.0)};
}

// By the moments about the first mean: E[(x - m)(y - m)] less the product of the means.
inline GloamSurfaceMoments gloam_moments_add(const GloamSurfaceMoments& a, const GloamSurfaceMoments& b) {
    if (!(b.weight > 0.0)) return a;
    if (!(a.weight > 0.0)) return b;
    const double weight = a.weight + b.weight;
    const dvec3 apart = b.mean - a.mean;
    const dvec3 mean = b.weight * apart / weight;  // about a.mean
    const dvec3 squares = (a.weight * a.variance + b.weight * (b.variance + apart * apart)) / weight;
    const dvec3 crossed(apart.y * apart.z, apart.z * apart.x, apart.x * apart.y);
    const dvec3 products = (a.weight * a.covariance + b.weight * (b.covariance + crossed)) / weight;
    return {weight, a.mean + mean, squares - mean * mean,
            products - dvec3(mean.y * mean.z, mean.z * mean.x, mean.x * mean.y)};
}

// n^T C n.
inline double gloam_moments_along(const GloamSurfaceMoments& moments, dvec3 direction) {
    const dvec3& v = moments.variance;
    const dvec3& c = moments.covariance;
    const dmat3 matrix{{v.x, c.z, c.y}, {c.z, v.y, c.x}, {c.y, c.x, v.z}};
    const double along = dot(direction, matrix * direction);
    return along > 0.0 ? along : 0.0;
}

inline dvec3 gloam_camera_centered_previous(dvec3 position, dvec3 eye_delta) {
    const dvec3 previous = position + eye_delta;
    return is_finite(previous) ? previous : dvec3(0.0);
}

inline bool gloam_uv_from_clip(dvec4 clip, dvec2& uv) {
    uv = dvec2(0.0);
    const double w = clip.w;
    if (!(w >= 1e-30 && w <= 0x1p126 && abs(clip.x) <= w && abs(clip.y) <= w)) return false;
    uv = dvec2(clip) / (2.0 * w) + 0.5;
    return true;
}

inline bool gloam_reproject_clip(dvec4 clip_position, dmat4 previous_from_current, dvec2& uv) {
    return gloam_uv_from_clip(previous_from_current * clip_position, uv);
}

inline dvec4 gloam_previous_clip_static(dvec4 clip, dmat4 inverse_projection, dmat4 inverse_view,
                                        dmat4 previous_view, dmat4 previous_projection) {
    const dvec4 previous = previous_projection * previous_view * inverse_view * inverse_projection * clip;
    return is_finite(previous) ? previous : dvec4(0.0);
}

inline dvec4 gloam_previous_clip_moving(dvec4 clip, dmat4 inverse_projection, dmat4 inverse_view,
                                        dmat4 inverse_model, dmat4 previous_model, dmat4 previous_view,
                                        dmat4 previous_projection) {
    const dmat4 world = previous_model * inverse_model * inverse_view;
    return gloam_previous_clip_static(clip, inverse_projection, world, previous_view, previous_projection);
}

inline dvec3 gloam_previous_world(dvec3 world, dmat4 inverse_model, dmat4 previous_model) {
    const dvec3 previous = previous_model * inverse_model * dvec4(world, 1.0);
    return is_finite(previous) ? previous : dvec3(0.0);
}

inline double gloam_previous_depth(dvec3 previous_world, dmat4 previous_view) {
    const double depth = -(previous_view * dvec4(previous_world, 1.0)).z;
    return is_finite(depth) ? depth : 0.0;
}

struct GloamTangentAxes {
    dvec3 along;
    dvec3 height;
    dvec2 normal;
    double weight;
};

inline GloamTangentAxes gloam_tangent_axes(dvec2 direction, dvec3 view, dvec3 normal) {
    const GloamSlice slice = gloam_slice(direction, view, normal);
    const double weight = length(dvec2(max(dot(normal, view), 0.0), dot(normal, slice.tangent)));
    const dvec2 plane = weight > 0.0 ? on_circle(slice.angle) : dvec2(0.0);
    return {plane.x * slice.tangent - plane.y * view, normal / max(weight, 1e-18), plane, weight};
}

inline double gloam_tangent_whole(dvec2 plane) {
    return plane.x + abs(plane.y) * std::atan2(abs(plane.y), plane.x);
}

// Side by side, each tap from where it is to the own point.
inline dvec4 gloam_tap_pair(dvec2 along, dvec2 height, dvec2 slope, double own, dvec2 depth,
                            bool orthographic) {
    dvec4 taps{};
    for (int side = 0; side < 2; ++side) {
        const double towards = side == 0 ? 1.0 : -1.0;
        const double seen = orthographic ? 1.0 : depth[side];
        const double before = orthographic ? own - depth[side] : own;
        taps[side] = towards * (along[side] * seen - slope.y * before);
        taps[side + 2] = height[side] * seen + slope.x * before;
    }
    return taps;
}

}  // namespace gloam::reference
