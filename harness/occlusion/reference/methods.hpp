// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/occlusion_points.hpp"
#include "reference/occlusion_slices.hpp"

// Whole methods, tap by tap, in the order of the sums that they are.
namespace gloam::reference {

struct GloamDisc {
    double epsilon;
};

// The mean of epsilon C(p, s_i) over the surface points s_i under the taps; one beyond the radius, or no
// higher than the bias above the tangent plane, contributes nothing.
inline GloamEstimate gloam_disc(dvec3 position, dvec3 normal, const GloamCamera& camera,
                                const GloamKernel& kernel, const GloamDisc& own,
                                const Fetch<double>& fetch_depth) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return {};
    const dvec3 n = gloam_safe_normalize(normal, dvec3(0.0));
    const dvec2 axes = gloam_camera_radius(kernel.radius, -position.z, camera);
    double sum = 0.0;
    unsigned samples = 0U;
    for (unsigned i = 1; i <= kernel.count; ++i) {
        const dvec2 tap = gloam_halton_disc(kernel.first + i, gloam_sincos(kernel.angle));
        const glm::ivec2 pixel =
            gloam_nearest_pixel(gloam_camera_uv(position, camera) + axes * tap, camera.size);
        const double depth = fetch_depth(pixel);
        if (gloam_tap_rejected(-position.z, depth, kernel.farthest)) continue;
        ++samples;
        const dvec3 point = gloam_camera_position(pixel, depth, camera);
        if (point == dvec3(0.0) || distance(point, position) > kernel.radius) continue;
        if (dot(point - position, n) > kernel.bias)
            sum += max(gloam_contribution_fox_compton(point - position, n, own.epsilon), 0.0);
    }
    return gloam_estimate(sum, samples, samples);
}

// gloam_plane_depth on the ray of a pixel.
inline double plane_depth_at(glm::ivec2 pixel, dvec3 point, dvec3 normal, const GloamCamera& camera) {
    const dvec2 ray(gloam_camera_position(pixel, 1.0, camera));
    return gloam_plane_depth(ray, point, normal, camera.orthographic);
}

struct GloamHemisphere {
    double range;
    int layers;
};

// The mean over the points p + R s_i of whether the layers block them, each moved along its plane to the
// pixel's centre; a point behind the eye is not taken.
inline GloamEstimate gloam_hemisphere(dvec3 position, dvec3 normal, const GloamCamera& camera,
                                      const GloamKernel& kernel, const GloamHemisphere& own,
                                      const Fetch<dvec4>& fetch_layers) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return {};
    const dmat3 frame = gloam_tangent_frame(normalize(normal));
    double blocked = 0.0;
    unsigned samples = 0U;
    for (unsigned i = 1; i <= kernel.count; ++i) {
        const dvec3 s = gloam_hemisphere_cosine(gloam_halton_3d(kernel.first + i));
        const dvec3 point = position + kernel.radius * (frame * gloam_rotate_hemisphere(s, kernel.angle));
        if (s == dvec3(0.0) || gloam_is_background(-point.z)) continue;
        const glm::ivec2 pixel = gloam_nearest_pixel(gloam_camera_uv(point, camera), camera.size);
        const double depth = plane_depth_at(pixel, point, frame[2], camera);
        const dvec4 depths = fetch_layers(pixel);
        if (gloam_tap_rejected(-position.z, depths.x, kernel.farthest)) continue;
        GloamLayersSeen seen{};
        for (int layer = 0; layer < own.layers; ++layer)
            seen = gloam_layers_add(
                seen,
                gloam_sample_blocked(depth, depth_of_layer(depths, layer), kernel.bias, own.range) ? 1.0
                                                                                                   : 0.0,
                {depths.y, depths.z, depths.w}, depth, layer, own.layers);
        blocked += seen.occlusion;
        ++samples;
    }
    return gloam_estimate(blocked, samples, samples);
}

struct GloamPoisson {
    double range;
    unsigned steps;
};

// The share of the rays of which a step is blocked. Each round through the disc is turned by another
// angle.
inline GloamEstimate gloam_poisson(dvec3 position, dvec3 normal, const GloamCamera& camera,
                                   const GloamKernel& kernel, const GloamPoisson& own,
                                   const Fetch<double>& fetch_depth) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return {};
    const dmat3 frame = gloam_tangent_frame(normalize(normal));
    const unsigned steps = std::max(own.steps, 1U);
    const auto blocked = [&](dvec3 point) {
        const glm::ivec2 pixel = gloam_nearest_pixel(gloam_camera_uv(point, camera), camera.size);
        if (gloam_is_background(-point.z)) return false;
        if (pixel == gloam_nearest_pixel(gloam_camera_uv(position, camera), camera.size)) return false;
        const double depth = plane_depth_at(pixel, point, frame[2], camera);
        return gloam_sample_blocked(depth, fetch_depth(pixel), kernel.bias, own.range);
    };
    const unsigned samples = gloam_whole_samples(kernel.count, steps);
    const unsigned rays = samples / steps;
    unsigned ended = 0U;
    for (unsigned r = 0; r < rays; ++r) {
        const unsigned i = kernel.first / steps + r;
        const double turn = kernel.angle + 2.0 * pi * gloam_radical_inverse(i / 64U, 2U);
        const dvec3 ray = frame * gloam_hemisphere_lift(gloam_rotate_disc(gloam_poisson_disc(i), turn));
        const double jitter =
            fract(gloam_halton_3d(i + 1U).y + gloam_unit_interval(kernel.angle / (2.0 * pi)));
        bool any = false;
        for (unsigned k = 0; k < steps; ++k)
            any = any || blocked(gloam_eye_march(position, ray, kernel.radius, k, steps, jitter));
        ended += any ? 1U : 0U;
    }
    return gloam_estimate(ended, rays, samples);
}

struct GloamSphereProxy {
    double intensity;
};

// The sum over the pixels of the disc, each a ball as wide as itself, from taps of density 1 / (2 pi rho): a
// tap stands for 2 rho times the disc's pixels.
inline GloamEstimate gloam_sphere_proxy(dvec3 position, dvec3 normal, const GloamCamera& camera,
                                        const GloamKernel& kernel, const GloamSphereProxy& own,
                                        const Fetch<double>& fetch_depth) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return {};
    const dvec3 n = gloam_safe_normalize(normal, dvec3(0.0));
    const dvec2 uv = gloam_camera_uv(position, camera);
    const dvec2 axes = gloam_camera_radius(kernel.radius, -position.z, camera);
    const double pixels = pi * axes.x * camera.size.x * axes.y * camera.size.y;
    double sum = 0.0;
    for (unsigned i = 1; i <= kernel.count; ++i) {
        const dvec2 zeta = gloam_halton_2d(kernel.first + i);
        const dvec2 tap = gloam_rotate_disc(zeta.y * gloam_circle_point(zeta.x), kernel.angle);
        const glm::ivec2 pixel = gloam_nearest_pixel(uv + axes * tap, camera.size);
        if (pixel == gloam_nearest_pixel(uv, camera.size)) continue;
        const double depth = fetch_depth(pixel);
        const dvec3 offset = gloam_camera_position(pixel, depth, camera) - position;
        if (gloam_is_background(depth) || length(offset) > kernel.radius) continue;
        if (!(dot(offset, n) > kernel.bias)) continue;
        const dvec2 across =
            kernel.radius / (gloam_camera_radius(kernel.radius, depth, camera) * dvec2(camera.size));
        const double ball = sqrt(across.x * across.y) / 2.0;
        sum += 2.0 * zeta.y * pixels * gloam_contribution_sphere_cosine(offset, n, ball);
    }
    return gloam_estimate(own.intensity * sum, kernel.count, kernel.count);
}

// The solid share of the chords at pairs of opposite taps, weighted by the chords. The surface of a tap is
// moved along its plane to the aimed place; background lies far behind.
inline GloamEstimate gloam_volumetric(dvec3 position, dvec3 normal, const GloamCamera& camera,
                                      const GloamKernel& kernel, const Fetch<double>& fetch_depth) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return {};
    const dvec3 n = gloam_safe_normalize(normal, dvec3(0.0));
    const dvec3 view = camera.orthographic ? dvec3(0.0, 0.0, 1.0) : normalize(-position);
    const double facing = max(dot(view, n), 1e-4);
    const dvec2 axes = gloam_camera_radius(kernel.radius, -position.z, camera);
    const auto ratio = [&](dvec2 tap) {
        const glm::ivec2 pixel =
            gloam_nearest_pixel(gloam_camera_uv(position, camera) + axes * tap, camera.size);
        const double seen = fetch_depth(pixel);
        const double depth = gloam_is_background(seen) ? 1e4 * kernel.radius - position.z : seen;
        const dvec3 aim(kernel.radius * tap * dvec2(1.0, camera.p00_p11.y < 0.0 ? -1.0 : 1.0), 0.0);
        const double height =
            gloam_height_at(gloam_camera_position(pixel, depth, camera) - position, aim, n, facing);
        return gloam_line_ratio(height, gloam_chord_half_height(tap, kernel.radius));
    };
    double solid = 0.0;
    double whole = 0.0;
    for (unsigned i = 0; i < kernel.count; i += 2U) {
        const dvec2 tap = gloam_halton_disc((kernel.first + i) / 2U + 1U, gloam_sincos(kernel.angle));
        const dvec2 pair = gloam_line_pair({ratio(tap), ratio(-tap)}, 0.35, 1.0);
        solid += gloam_chord_half_height(tap, kernel.radius) * (pair.x + pair.y);
        whole += gloam_chord_half_height(tap, kernel.radius) * 2.0;
    }
    return gloam_estimate(solid, whole, gloam_paired_samples(kernel.count));
}

// What a tap of a slice sees; tells: a surface, which is neither the pixel's own nor rejected.
struct SliceTap {
    dvec3 offset;
    bool tells;
};

// The estimate of all slices of a kernel. add(slice, n, tap) gives (occluded, whole) of a slice, n the unit
// normal; tap(side, i) is tap i to the side 1 or -1, at place((i + jitter) / steps, the radius in
// pixels) of the radius.
template <class Place, class Add>
GloamEstimate gather_slices(dvec3 position, dvec3 normal, const GloamCamera& camera,
                            const GloamKernel& kernel, unsigned steps, const Fetch<double>& fetch_depth,
                            const Place& place, const Add& add) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return {};
    const dvec3 n = gloam_safe_normalize(normal, dvec3(0.0));
    const dvec3 view = camera.orthographic ? dvec3(0.0, 0.0, 1.0) : normalize(-position);
    const dvec2 uv = gloam_camera_uv(position, camera);
    const dvec2 axes = gloam_camera_radius(kernel.radius, -position.z, camera);
    const dvec2 reach = axes * dvec2(camera.size);
    const unsigned slices = gloam_whole_samples(kernel.count, 2U * steps) / (2U * steps);
    dvec2 sum(0.0);
    for (unsigned s = 1; s <= slices; ++s) {
        const GloamSliceSample sample =
            gloam_slice_sample(kernel.first / (2U * steps) + s, gloam_turns(kernel.angle));
        const dvec2 upright(1.0, camera.p00_p11.y < 0.0 ? -1.0 : 1.0);
        const auto tap = [&](double side, unsigned i) {
            const double share = place((i + sample.jitter) / steps, max(reach.x, reach.y));
            const glm::ivec2 pixel =
                gloam_nearest_pixel(uv + side * share * axes * sample.direction, camera.size);
            const double depth = fetch_depth(pixel);
            const dvec3 point = gloam_camera_position(pixel, depth, camera);
            const bool own_pixel = pixel == gloam_nearest_pixel(uv, camera.size);
            return SliceTap{point - position, !own_pixel && point != dvec3(0.0) &&
                                                  !gloam_tap_rejected(-position.z, depth, kernel.farthest)};
        };
        sum += add(gloam_slice(sample.direction * upright, view, n), n, tap);
    }
    return gloam_slice_estimate(sum.x, sum.y, slices, steps);
}

struct GloamGtao {
    unsigned steps;
};

// Slice by slice the highest horizon on either side.
inline GloamEstimate gloam_gtao(dvec3 position, dvec3 normal, const GloamCamera& camera,
                                const GloamKernel& kernel, const GloamGtao& own,
                                const Fetch<double>& fetch_depth) {
    const unsigned steps = std::max(own.steps, 1U);
    const auto add = [&](const GloamSlice& slice, dvec3 n, const auto& tap) {
        const auto horizon = [&](double side) {
            const double lowest = -side * slice.normal.y;
            double highest = lowest;
            for (unsigned i = 0; i < steps; ++i) {
                const SliceTap seen = tap(side, i);
                if (!seen.tells || !(dot(seen.offset, n) > kernel.bias)) continue;
                const dvec3 offset = gloam_into_slice(seen.offset, cross(slice.tangent, slice.view), n);
                const dvec2 inside(dot(offset, slice.view), dot(offset, slice.tangent));
                highest = gloam_gtao_horizon(highest, lowest, inside, kernel.radius);
            }
            return highest;
        };
        const double occluded =
            gloam_gtao_side(horizon(-1.0), -slice.angle, {slice.normal.x, -slice.normal.y}) +
            gloam_gtao_side(horizon(1.0), slice.angle, slice.normal);
        return slice.weight * dvec2(occluded, gloam_slice_whole(slice));
    };
    const auto squared = [](double share, double) { return share * share; };
    return gather_slices(position, normal, camera, kernel, steps, fetch_depth, squared, add);
}

struct GloamSweep {
    unsigned steps;
    double feature_thickness;
    unsigned falloff;
};

// Slice by slice the directions that each tap uncovers on either side, with the falloff at their distance.
// What lies behind a horizon is I(H) - I(h), calculated anew for each tap.
inline GloamEstimate gloam_sweep(dvec3 position, dvec3 normal, const GloamCamera& camera,
                                 const GloamKernel& kernel, const GloamSweep& own,
                                 const Fetch<double>& fetch_depth) {
    const unsigned steps = std::max(own.steps, 1U);
    const double thickness = own.feature_thickness > 0.0 ? std::min(own.feature_thickness, 1e18) : 0.0;
    const auto add = [&](const GloamSlice& slice, dvec3 n, const auto& tap) {
        const auto occluded = [&](double towards) {
            const GloamSlice half_plane = gloam_sweep_slice(slice, towards);
            GloamSweepSide side = gloam_sweep_side(-half_plane.normal.y);
            for (unsigned i = 0; i < steps; ++i) {
                const SliceTap seen = tap(towards, i);
                const dvec3 offset = gloam_into_slice(seen.offset, cross(slice.tangent, slice.view), n);
                const dvec2 within = dvec2(dot(offset, slice.view), towards * dot(offset, slice.tangent));
                const double sine = sqrt(max(1.0 - side.horizon * side.horizon, 0.0));
                const bool rises = dot(seen.offset, n) > kernel.bias;
                side.behind = gloam_sweep_behind({side.horizon, sine}, half_plane);
                side = gloam_sweep_tap(side, half_plane, within / kernel.radius, seen.tells, rises,
                                       own.falloff, thickness);
            }
            return side.occluded + side.feature;
        };
        if (!(slice.weight > 0.0)) return dvec2(0.0);
        return slice.weight * dvec2(occluded(1.0) + occluded(-1.0), gloam_slice_whole(slice));
    };
    return gather_slices(position, normal, camera, kernel, steps, fetch_depth, gloam_slice_place, add);
}

}  // namespace gloam::reference
