// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_POSITION_GLSL
#define GLOAM_GEOMETRY_POSITION_GLSL

#include "gloam/geometry/background.glsl"

// The two elements p00_p11 = (P[0][0], P[1][1]) of a symmetric projection carry the field of view and the direction
// of the y axis: P11 is negative where normalised device y points down (Vulkan), positive where it points up (OpenGL,
// whose pixel rows then count from the bottom). The formulas are the same.

// normalised device coordinates of a pixel's centre (NDC-pixel): `(2 x + 1 - width) / width` [definition of the pixel
// centre].
// pixel: integer pixel; one outside the image gives coordinates outside [-1, 1].
// size: image size in pixels, 1 to 2^22; a size below 1 gives (0, 0).
// Returns coordinates in (-1, 1) for a pixel of the image. Error: at most 2.5 ulp, for pixels below 2^22.
vec2 gloam_ndc_from_pixel(ivec2 pixel, ivec2 size) {
    if (size.x < 1 || size.y < 1) return vec2(0.0);
    vec2 extent = vec2(size);
    return (2.0 * vec2(pixel) + 1.0 - extent) / extent;
}

// texture coordinates of normalised device coordinates (UV-ndc): `ndc / 2 + 1/2` [convention].
// ndc: in [-1, 1]^2 inside the image.
// Returns coordinates in [0, 1]^2 inside the image; (2, 2), a point outside every image, where ndc is infinite or NaN.
// Error: at most 1 ulp.
vec2 gloam_uv_from_ndc(vec2 ndc) {
    return gloam_is_finite2(ndc) ? 0.5 * ndc + 0.5 : vec2(2.0);
}

// view-space position under a pixel, perspective (POSITION-perspective): `(ndc.x / P00, ndc.y / P11, -1) d` [inverse of
// the projection].
// ndc: normalised device coordinates. depth: eye-linear, world units. p00_p11: projection elements, not zero.
// Returns the position in world units; the zero vector, which is read as background everywhere, for background depth
// and wherever the position would not be finite. Error: at most 3 ulp in each component.
vec3 gloam_view_position_perspective(vec2 ndc, float depth, vec2 p00_p11) {
    if (gloam_is_background(depth)) return vec3(0.0);
    vec3 position = vec3(ndc / p00_p11 * depth, -depth);
    return gloam_is_finite3(position) ? position : vec3(0.0);
}

// view-space position under a pixel, orthographic (POSITION-orthographic): `(ndc.x / P00, ndc.y / P11, -d)` [inverse of
// the projection].
// ndc, depth, p00_p11 and the result: as for gloam_view_position_perspective. Error: at most 2.5 ulp in each component.
vec3 gloam_view_position_orthographic(vec2 ndc, float depth, vec2 p00_p11) {
    if (gloam_is_background(depth)) return vec3(0.0);
    vec3 position = vec3(ndc / p00_p11, -depth);
    return gloam_is_finite3(position) ? position : vec3(0.0);
}

// normalised device coordinates of a position, perspective (NDC-perspective): `(P00 x, P11 y) / -z` [the projection].
// view_position: world units. p00_p11: projection elements.
// Returns coordinates in [-1, 1]^2 inside the frustum's sides; (2, 2), a point outside every image, for a position
// that is not in front of the eye (-z not a positive finite depth) and wherever the coordinates would not be finite.
// Error: at most 3 ulp.
vec2 gloam_ndc_perspective(vec3 view_position, vec2 p00_p11) {
    if (gloam_is_background(-view_position.z)) return vec2(2.0);
    vec2 ndc = p00_p11 * view_position.xy / -view_position.z;
    return gloam_is_finite2(ndc) ? ndc : vec2(2.0);
}

// normalised device coordinates of a position, orthographic (NDC-orthographic): `(P00 x, P11 y)` [the projection].
// view_position, p00_p11 and what it returns: as for gloam_ndc_perspective. Error: at most 1 ulp.
vec2 gloam_ndc_orthographic(vec3 view_position, vec2 p00_p11) {
    if (gloam_is_background(-view_position.z)) return vec2(2.0);
    vec2 ndc = p00_p11 * view_position.xy;
    return gloam_is_finite2(ndc) ? ndc : vec2(2.0);
}

#endif
