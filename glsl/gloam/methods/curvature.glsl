// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_CURVATURE_GLSL
#define GLOAM_METHODS_CURVATURE_GLSL

#include "gloam/gather/method.glsl"
#include "gloam/geometry/surface.glsl"
#include "gloam/occlusion/curvature.glsl"

// Curvature (after Hattori et al. 2012; CS-K). It finds the two principal curvatures of the surface from the change
// of position and normal across the pixel, at the scale of the radius. The result is the occlusion of the quadric
// that has these curvatures. One estimate reads the four ends of a cross and counts as four samples. On a bowl that
// ends at the radius the result is cosine-weighted. Objects that do not belong to the surface have no effect.
struct GloamCurvature {
    float range;  // world units: the ends of a cross farther away than that lie on another surface; there the point
                  // itself stands for the end
};

// Pixels that one cross reads.
const uint GLOAM_CROSS_TAPS = 4u;

// The surface at a pixel, relative to the shaded point, or its change along an arm.
struct GloamNeighbor {
    vec3 offset;  // to it, view space, world units
    vec3 turn;    // its unit normal less that of the point
};

// Zero for the point's own pixel, for background, for what is farther away than the range, and for a surface without a
// normal.
// tap: in units of the radius.
GloamNeighbor gloam_neighbor(GloamFootprint footprint, vec2 tap, vec3 position, vec3 normal, float range) {
    ivec2 at = gloam_footprint_pixel(footprint, tap);
    float depth = gloam_fetch_depth(at);
    vec3 facing = gloam_fetch_normal(at);
    facing *= inversesqrt(max(dot(facing, facing), GLOAM_LEAST_SQUARE));
    vec3 offset = gloam_footprint_position(footprint, at, depth) - position;
    bool known = at != footprint.pixel && gloam_tap_sees(depth) && dot(facing, facing) > 0.5 &&
                 dot(offset, offset) <= range * range;
    if (!known) return GloamNeighbor(vec3(0.0), vec3(0.0));  // WebGL has no ?: of structures
    return GloamNeighbor(offset, facing - normal);
}

// Change of position and normal from one end of an arm to the other.
GloamNeighbor gloam_across(GloamFootprint footprint, vec2 arm, vec3 position, vec3 normal, float range) {
    GloamNeighbor ahead = gloam_neighbor(footprint, arm, position, normal, range);
    GloamNeighbor behind = gloam_neighbor(footprint, -arm, position, normal, range);
    return GloamNeighbor(ahead.offset - behind.offset, ahead.turn - behind.turn);
}

// occlusion of the quadric through the surroundings (METHOD-curvature): `mean of the occlusion of (k_1, k_2)` [after
// Hattori et al. 2012, CS-K].
// All samples of one pixel in one frame: crosses of arms between half the radius and the radius, turned from one to the
// next. Error: that of gloam_principal_curvatures, but for taps within rounding of a pixel's border.
GloamEstimate gloam_curvature(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel,
                              GloamCurvature settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    float turns = gloam_turns(kernel.angle);
    float range = clamp(settings.range, 0.0, GLOAM_FARTHEST);
    uint crosses = gloam_whole_samples(kernel.count, GLOAM_CROSS_TAPS) / GLOAM_CROSS_TAPS;
    float sum = 0.0;
    for (uint i = 0u; i < crosses; ++i) {
        vec3 random = gloam_halton_point(kernel.first / GLOAM_CROSS_TAPS + i + 1u);
        vec2 arm = (0.5 + 0.5 * fract(random.y + turns)) * gloam_sincos_turns(0.25 * fract(random.x + turns));
        GloamNeighbor first = gloam_across(footprint, arm, position, n, range);
        GloamNeighbor second = gloam_across(footprint, vec2(-arm.y, arm.x), position, n, range);
        vec2 curvatures = gloam_principal_curvatures(first.offset, second.offset, first.turn, second.turn);
        sum += gloam_occlusion_curvature(curvatures.x, curvatures.y, kernel.radius);
    }
    return gloam_estimate(sum, float(crosses), crosses * GLOAM_CROSS_TAPS);
}

#endif
