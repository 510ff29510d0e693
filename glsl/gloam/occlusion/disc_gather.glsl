// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_DISC_GATHER_GLSL
#define GLOAM_OCCLUSION_DISC_GATHER_GLSL

#include "gloam/geometry/camera.glsl"
#include "gloam/geometry/safe_normalize.glsl"
#include "gloam/occlusion/estimator.glsl"
#include "gloam/occlusion/fox_compton.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/sampling/disc.glsl"
#include "gloam/sampling/halton.glsl"
#include "gloam/sampling/rotation.glsl"

// Crease shading of one pixel by the surface points under a disc around it (TSSAO-2, -12 and -4 with the kernel of TSSAO-13). The
// mean over the disc's pixels of cos(s - p, n) min(1, epsilon / |s - p|): a measure of how concave the surface is, which
// looks like occlusion but is not the integral of TSSAO-1, and depends on epsilon.

// Defined by the user: eye-linear depth of a pixel inside the image, in world units.
float gloam_fetch_depth(ivec2 pixel);

// Contribution of the surface point at a tap.
// position, normal: of the shaded point, view space, world units; unit normal. at: the tap's pixel, inside the image.
// epsilon: world units, see gloam_contribution_fox_compton_scaled.
// Returns a contribution in [0, 1]; 0 for background, for a point beyond the kernel's radius, and for one no higher than the bias
// above the tangent plane: there noise would decide. Error: 4e-6, growing as the point comes nearer than
// a thousandth of the depth.
float gloam_disc_contribution(vec3 position, vec3 normal, ivec2 at, GloamCamera camera, GloamKernel kernel, float epsilon) {
    float depth = gloam_fetch_depth(at);
    if (gloam_is_background(depth)) return 0.0;
    vec3 surface = gloam_camera_position(at, depth, camera);
    vec3 offset = surface - position;
    bool inside = dot(offset, gloam_safe_normalize(offset, vec3(0.0))) <= kernel.radius;
    bool above = dot(offset, normal) > kernel.bias;
    return inside && above ? gloam_contribution_fox_compton_scaled(position, normal, surface, epsilon) : 0.0;
}

// All samples of one pixel in one frame.
// position: of the surface, view space, world units. normal: view space, any length. epsilon: world units, 0.01 to 0.1 of the radius.
// Returns (sum, count) for gloam_estimator_mean; outside the image the nearest pixel counts. (0, 0) where there is nothing to
// gather: background, no normal, no radius. Error: 1e-6 a sample, but for taps within rounding of a pixel's border.
vec2 gloam_disc_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, float epsilon) {
    vec2 accumulated = vec2(0.0);
    if (!gloam_can_gather(position, normal, kernel.radius)) return accumulated;
    vec3 n = gloam_safe_normalize(normal, vec3(0.0));
    vec2 center = gloam_camera_uv(position, camera);
    vec2 reach = gloam_camera_radius(kernel.radius, -position.z, camera);
    for (uint i = 0u; i < kernel.count; ++i) {
        vec2 point = gloam_rotate_disc(gloam_disc_sample(gloam_halton_2d(kernel.first + i + 1u)), kernel.angle);
        ivec2 at = gloam_nearest_pixel(center + reach * point, camera.size);
        accumulated = gloam_estimator_add(accumulated, gloam_disc_contribution(position, n, at, camera, kernel, epsilon));
    }
    return accumulated;
}

#endif
