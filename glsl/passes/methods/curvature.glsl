// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_CURVATURE_GLSL
#define GLOAM_METHODS_CURVATURE_GLSL

#include "gloam/geometry/camera.glsl"
#include "gloam/geometry/curvature.glsl"
#include "gloam/geometry/length.glsl"
#include "gloam/geometry/safe_normalize.glsl"
#include "gloam/occlusion/curvature.glsl"
#include "gloam/occlusion/estimator.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/method_parameters.glsl"
#include "gloam/sampling/circle.glsl"
#include "gloam/sampling/radical_inverse.glsl"

// Curvature (after Hattori et al. 2012; CS-K): the two principal curvatures of the surface, from how position and normal change across the
// pixel at the scale of the radius, and the occlusion of the quadric that has them. One estimate reads the four ends of a cross and
// counts as four samples. Cosine-weighted on a bowl that ends at the radius; of what does not belong to the surface it sees nothing.
// Reads range: the ends of a cross farther away than that lie on another surface; there the point itself stands for the end.

// Defined by the user: eye-linear depth, in world units, and view-space normal facing the eye, any length, of a pixel inside the image.
float gloam_fetch_depth(ivec2 pixel);
vec3 gloam_fetch_normal(ivec2 pixel);

// The surface at a pixel, as seen from the shaded point.
struct GloamNeighbor {
    vec3 offset;  // to it, view space, world units
    vec3 turn;    // its unit normal less that of the point
};

// Zero for background, for what is farther away than the range, and for a surface without a normal.
GloamNeighbor gloam_neighbor(vec2 uv, vec3 position, vec3 normal, GloamCamera camera, float range) {
    ivec2 at = gloam_nearest_pixel(uv, camera.size);
    float depth = gloam_fetch_depth(at);
    vec3 there = gloam_safe_normalize(gloam_fetch_normal(at), vec3(0.0));
    if (gloam_is_background(depth) || dot(there, there) < 0.5) return GloamNeighbor(vec3(0.0), vec3(0.0));
    vec3 offset = gloam_camera_position(at, depth, camera) - position;
    if (!(gloam_length(offset) <= range)) return GloamNeighbor(vec3(0.0), vec3(0.0));
    return GloamNeighbor(offset, there - normal);
}

// Change of position and normal from one end of an arm to the other.
GloamNeighbor gloam_across(vec2 center, vec2 arm, vec3 position, vec3 normal, GloamCamera camera, float range) {
    GloamNeighbor ahead = gloam_neighbor(center + arm, position, normal, camera, range);
    GloamNeighbor behind = gloam_neighbor(center - arm, position, normal, camera, range);
    return GloamNeighbor(ahead.offset - behind.offset, ahead.turn - behind.turn);
}

// Samples that are taken where `count` are asked for: those of whole crosses, at least one.
uint gloam_cross_samples(uint count) {
    return max(count / 4u, 1u) * 4u;
}
#define GLOAM_METHOD_SAMPLES(count, method) gloam_cross_samples(count)

// Crosses of arms between half the radius and the radius, turned from one to the next.
vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    if (!gloam_can_gather(position, normal, kernel.radius)) return vec2(0.0);
    vec3 n = gloam_safe_normalize(normal, vec3(0.0));
    vec2 center = gloam_camera_uv(position, camera);
    vec2 reach = gloam_camera_radius(kernel.radius, -position.z, camera);
    float turned = gloam_unit_interval(kernel.angle / 6.283185307);
    vec2 accumulated = vec2(0.0);
    for (uint i = 0u; i < gloam_cross_samples(kernel.count) / 4u; ++i) {
        uint index = kernel.first / 4u + i + 1u;
        float share = 0.5 + 0.5 * fract(gloam_radical_inverse(index, 3u) + turned);
        vec2 arm = gloam_circle_point(0.25 * fract(gloam_radical_inverse_base2(index) + turned));
        GloamNeighbor first = gloam_across(center, share * reach * arm, position, n, camera, method.range);
        GloamNeighbor second = gloam_across(center, share * reach * vec2(-arm.y, arm.x), position, n, camera, method.range);
        vec2 curvatures = gloam_principal_curvatures(first.offset, second.offset, first.turn, second.turn);
        accumulated += vec2(gloam_occlusion_curvature(curvatures.x, curvatures.y, kernel.radius), 1.0);
    }
    return gloam_estimator_of_weighted(accumulated, gloam_cross_samples(kernel.count));
}

#endif
