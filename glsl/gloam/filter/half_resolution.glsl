// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_HALF_RESOLUTION_GLSL
#define GLOAM_FILTER_HALF_RESOLUTION_GLSL

#include "gloam/geometry/safe_normalize.glsl"

// Which pixels an image of half the resolution stands for: its pixel p has what pixel 2 p of the full image has, not
// that of a point between four pixels. A side of n pixels becomes (n + 1) / 2, so odd sizes need no special case.
//
// The pixel centres of the half-size image are therefore not those of its sources: where a side of the full image is
// even, they are half a full pixel further along it. A camera with the half-size image in its middle therefore has
// another view space. Along that side x' = x + shift d (perspective, d the depth) or x' = x + shift (orthographic).
// Planes stay planes, and what is in front of what stays as it is.

// size of an image of half the resolution (HALF-size): `(n + 1) / 2, rounded down` [definition].
// size: of the full image, pixels, 0 to 2^30.
// Error: none.
ivec2 gloam_half_size(ivec2 size) {
    return (size + 1) / 2;
}

// full-size pixel that a half-size pixel stands for (HALF-source): `2 p` [definition].
// pixel: of the half-size image, within 2^30 of 0.
// Error: none.
ivec2 gloam_half_source(ivec2 pixel) {
    return 2 * pixel;
}

// between the rays of a half-size pixel and of its source (HALF-shift): `1 / (n p), n even; 0, n odd` [derived].
// How far the rays of the half-size image's pixels are from those of their sources, along one axis.
// p: element [0][0] (along x) or [1][1] (along y) of the full image's projection. size: of the full image along that
// axis, pixels, 1 to 2^24.
// Returns the distance at depth 1 (perspective; orthographic: in world units): 1 / (size p) for even sizes, 0 for odd
// ones, for sizes below 1, and for a p that is NaN or whose amount is not in [1e-9, 1e9]. Error: 3.5 ULP.
float gloam_half_shift(float p, int size) {
    bool even = size > 0 && (size & 1) == 0;
    return even && abs(p) >= 1e-9 && abs(p) <= 1e9 ? 1.0 / (float(size) * p) : 0.0;
}

// normal in the view space of the half-size image (HALF-normal): `(n.xy, n.z + shift . n.xy), normalised` [derived].
// For perspective.
// normal: in the view space of the full image. shift: gloam_half_shift along both axes.
// Returns a unit vector; 0 where the normal has no direction, is not finite, or the sum overflows. Error: 4e-7 for
// unit normals and shifts up to 0.5.
vec3 gloam_half_normal(vec3 normal, vec2 shift) {
    return gloam_safe_normalize(vec3(normal.xy, normal.z + dot(shift, normal.xy)), vec3(0.0));
}

#endif
