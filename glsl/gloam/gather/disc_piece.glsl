// SPDX-License-Identifier: MIT
#ifndef GLOAM_GATHER_DISC_PIECE_GLSL
#define GLOAM_GATHER_DISC_PIECE_GLSL

#include "gloam/gather/fetch.glsl"
#include "gloam/gather/footprint.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/proxies.glsl"

// Lower bound of the cosine at which a surface is seen. A pixel at the outline of a surface would otherwise represent
// more area than there is.
const float GLOAM_DISC_LEAST_FACING = 0.05;

// Contribution of the surface at a pixel as a disc with the area that the pixel covers there (CS-S).
// at: inside the image. position: of the shaded point, view space, world units. normal: of it, unit. kernel: of it the
// radius and the bias count. axes: half-axes of the radius at the shaded point's depth, pixels.
// Returns a contribution in [0, 1]; 0 where the pixel shows nothing, for what lies beyond the radius and for what is
// no higher than the bias over the tangent plane. Error: 1e-6 of the disc's own.
float gloam_disc_piece(GloamFootprint footprint, ivec2 at, vec3 position, vec3 normal, GloamKernel kernel, vec2 axes) {
    float depth = gloam_fetch_depth(at);
    vec3 offset = gloam_footprint_position(footprint, at, depth) - position;
    bool counts = gloam_tap_sees(depth) && dot(offset, offset) <= kernel.radius * kernel.radius &&
                  dot(offset, normal) > kernel.bias;
    if (!counts) return 0.0;
    // Half-axes of the radius there, pixels: so large is a pixel in the world.
    vec2 size = axes * (footprint.orthographic ? 1.0 : -position.z / depth);
    size = kernel.radius / size;
    vec3 emitter = gloam_safe_normalize(gloam_fetch_normal(at), vec3(0.0));
    vec3 ray = vec3(footprint.orthographic ? vec2(0.0) : gloam_footprint_ray(footprint, at), -1.0);
    float area = size.x * size.y / max(-dot(emitter, ray), GLOAM_DISC_LEAST_FACING);
    return gloam_contribution_disc_proxy_cosine(offset, normal, emitter, area, 1.0);
}

#endif
