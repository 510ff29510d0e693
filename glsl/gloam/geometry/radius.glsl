// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_RADIUS_GLSL
#define GLOAM_GEOMETRY_RADIUS_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/numeric/arithmetic.glsl"

// How large a world length appears at a depth: half-axes of the image of a disc parallel to the screen. The factor
// 1/2 takes normalised device coordinates, two units wide, to texture coordinates. Signs of the projection (y down)
// do not matter.

// number read as a length (LENGTH): `x inside [0, FLT_MAX], else the nearer end; 0 for NaN` [convention].
// x: any float. Returns a number in [0, FLT_MAX]. Error: none.
float gloam_positive_length(float x) {
    return x > 0.0 ? (x <= GLOAM_LARGEST ? x : GLOAM_LARGEST) : 0.0;
}

// projected radius of a world length (RADIUS-uv): `R (|P00|, |P11|) / (2 d)` [the projection].
// radius: R, world units, >= 0 (negative and NaN count as 0). depth: eye-linear, world units. p00_p11: projection
// elements.
// Returns the half-axes in texture coordinates, at most FLT_MAX; (0, 0) for background depth. Error: at most 3 ulp.
vec2 gloam_projected_radius_uv(float radius, float depth, vec2 p00_p11) {
    if (gloam_is_background(depth)) return vec2(0.0);
    vec2 axes = 0.5 * abs(p00_p11) * (gloam_positive_length(radius) / depth);
    return vec2(gloam_positive_length(axes.x), gloam_positive_length(axes.y));
}

// projected radius of a world length (RADIUS-uv-orthographic): `R (|P00|, |P11|) / 2` [the projection].
// radius, depth, p00_p11 and what it returns: as for gloam_projected_radius_uv. Error: at most 1 ulp.
vec2 gloam_projected_radius_uv_orthographic(float radius, float depth, vec2 p00_p11) {
    if (gloam_is_background(depth)) return vec2(0.0);
    vec2 axes = 0.5 * abs(p00_p11) * gloam_positive_length(radius);
    return vec2(gloam_positive_length(axes.x), gloam_positive_length(axes.y));
}

// projected radius held below a cap (CS-G-cap): `r min(1, cap / max(r_x, r_y))` [Gears of War 2 (Smedberg and Wright
// 2009)].
// The taps of near pixels stay in the cache; both half-axes shrink alike, and with them the radius of influence in the
// world.
// axes: half-axes of the projected radius, pixels, >= 0 (negative and NaN count as 0). most: the cap, pixels, >= 0
// (the same).
// Returns the half-axes, the larger at most `most`. Error: 3.5 ULP for sizes up to 1e18.
vec2 gloam_radius_cap(vec2 axes, float most) {
    vec2 reach = vec2(gloam_positive_length(axes.x), gloam_positive_length(axes.y));
    float larger = max(reach.x, reach.y);
    float cap = gloam_positive_length(most);
    if (!(larger > cap)) return reach;
    // Not reach * (cap / larger): that quotient may be subnormal, and be flushed to 0.
    return cap * vec2(gloam_length_ratio(reach.x, larger), gloam_length_ratio(reach.y, larger));
}

// Radius of the image of a sampling disc (ISSAO-P), in units of the focal length: times P11 H / 2 it is in pixels.

// image of a disc parallel to the screen (ISSAO-P-parallel): `R / d` [ISSAO, section on the projected disc; derived].
// Its image is a circle, whatever the paper says of an ellipse.
// position: centre of the disc, view space, world units. radius: R, world units, >= 0. largest: upper bound of the
// result, >= 0.
// Returns a radius in [0, largest]; 0 for a position behind the eye or not finite and for R not positive or NaN.
// Error: 2.5 ULP.
float gloam_covering_radius_parallel(vec3 position, float radius, float largest) {
    if (!gloam_is_finite3(position) || gloam_is_background(-position.z) || !(radius > 0.0 && largest > 0.0)) return 0.0;
    float depth = clamp(-position.z, GLOAM_SMALLEST, GLOAM_LARGEST_DIVISOR);
    float r = radius / depth;
    return min(r, gloam_positive_length(largest));
}

// circle that covers the image of a disc across the view ray (ISSAO-P): `R / (cos t (d - R sin t))` [ISSAO, section on
// the projected disc; derived].
// The farthest point of its elliptic image from that of the centre; t is the angle off the axis. The reading under
// which the paper's ellipse and covering circle make sense; never below the other.
// position: centre of the disc, view space, world units, |position| within [1e-12, 1e12]. radius: R, world units, >= 0.
// largest: upper bound of the result, >= 0: the screen's diagonal.
// Returns a radius in [0, largest]; largest where the disc reaches the plane of the eye; 0 for a position behind the
// eye or not finite and for R not positive or NaN. Error: 8 ULP where R sin t is at most half of d; what the
// subtraction loses beyond.
float gloam_covering_radius_perpendicular(vec3 position, float radius, float largest) {
    if (!gloam_is_finite3(position) || gloam_is_background(-position.z) || !(radius > 0.0 && largest > 0.0)) return 0.0;
    float depth = -position.z;
    float across = gloam_sqrt(dot(position.xy, position.xy));
    float along = gloam_sqrt(dot(position, position));
    // sin t = across / along, cos t = depth / along.
    float denominator = (depth / along) * (depth - radius * (across / along));
    if (!(denominator >= GLOAM_SMALLEST)) return gloam_positive_length(largest);
    float r = radius / min(denominator, GLOAM_LARGEST_DIVISOR);
    return min(r, gloam_positive_length(largest));
}

#endif
