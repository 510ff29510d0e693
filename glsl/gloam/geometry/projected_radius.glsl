// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_PROJECTED_RADIUS_GLSL
#define GLOAM_GEOMETRY_PROJECTED_RADIUS_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/numeric/constants.glsl"

// How large a world length appears at a depth: half-axes of the image of a disc parallel to the screen. The factor
// 1/2 takes normalised device coordinates, two units wide, to texture coordinates. Signs of the projection (y down)
// do not matter.

// number read as a length (LENGTH): `x inside [0, FLT_MAX], else the nearer end; 0 for NaN` [convention].
// A length that is not positive counts as 0, and so does NaN; one too large for a float is the largest float.
// x: any float. Returns a number in [0, FLT_MAX]. Error: none.
float gloam_positive_length(float x) {
    return x > 0.0 ? (x <= GLOAM_LARGEST ? x : GLOAM_LARGEST) : 0.0;
}

// projected radius of a world length (RADIUS-uv): `R (|P00|, |P11|) / (2 d)` [the projection].
// Projected radius in texture coordinates, perspective: R (|P00|, |P11|) / (2 d).
// radius: R, world units, >= 0 (negative and NaN count as 0). depth: eye-linear, world units. p00_p11: projection
// elements.
// Returns the half-axes in texture coordinates, at most FLT_MAX; (0, 0) for background depth. Error: at most 3 ulp.
vec2 gloam_projected_radius_uv(float radius, float depth, vec2 p00_p11) {
    if (gloam_is_background(depth)) return vec2(0.0);
    vec2 axes = 0.5 * abs(p00_p11) * (gloam_positive_length(radius) / depth);
    return vec2(gloam_positive_length(axes.x), gloam_positive_length(axes.y));
}

// projected radius of a world length (RADIUS-uv-orthographic): `R (|P00|, |P11|) / 2` [the projection].
// radius: R, world units, >= 0 (negative and NaN count as 0). depth: eye-linear, world units. p00_p11: projection
// elements.
// Returns the half-axes in texture coordinates, at most FLT_MAX; (0, 0) for background depth. Error: at most 1 ulp.
vec2 gloam_projected_radius_uv_orthographic(float radius, float depth, vec2 p00_p11) {
    if (gloam_is_background(depth)) return vec2(0.0);
    vec2 axes = 0.5 * abs(p00_p11) * gloam_positive_length(radius);
    return vec2(gloam_positive_length(axes.x), gloam_positive_length(axes.y));
}

#endif
