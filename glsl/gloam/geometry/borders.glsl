// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_BORDERS_GLSL
#define GLOAM_GEOMETRY_BORDERS_GLSL

#include "gloam/geometry/finite.glsl"

// What a kernel reads beyond the frame (TSSAO-BORDER): the nearest pixel of the edge, or a guard band, rendered
// around the frame and cropped. A band is a whole number of pixels on each side, so the guard actually rendered is
// border / size, a little different along x and y; the field of view and the texture coordinates must use that one
// (gloam_guard_band_guard), not the guard asked for, or the cropped image is scaled.

// nearest pixel of the image (TSSAO-BORDER): `clamp(p, 0, size - 1)` [TSSAO, frame borders].
// pixel: integer pixel. size: image size in pixels; below 1 it is read as 1.
// Returns the pixel with each coordinate taken into [0, size - 1]. Error: none.
ivec2 gloam_clamp_to_edge(ivec2 pixel, ivec2 size) {
    return clamp(pixel, ivec2(0), max(size, ivec2(1)) - 1);
}

// width of the guard band in pixels (TSSAO-BORDER-width): `floor(g size + 1/2)` [TSSAO, frame borders].
// Width of the guard band in pixels: guard times size, rounded to the nearest integer, the same on opposite sides.
// size: size of the cropped image in pixels, at most 2^22 a side; below 0 it is read as 0.
// guard: part of the image added on each side, 0 to 1 (0.05 to 0.1 is usual); outside the nearer end, 0 for NaN.
// Returns the pixels to add on the left and right (x), top and bottom (y). Error: none, but for products within
// rounding of 1/2.
ivec2 gloam_guard_band_border(ivec2 size, float guard) {
    float part = guard > 0.0 ? (guard < 1.0 ? guard : 1.0) : 0.0;
    vec2 width = part * vec2(max(size, ivec2(0)));
    // Not floor(width + 0.5): that sum rounds 0.49999997 up to 1.
    vec2 whole = floor(width);
    return ivec2(whole + step(vec2(0.5), width - whole));
}

// guard actually rendered (TSSAO-BORDER-guard): `border / size` [TSSAO, frame borders].
// size: size of the cropped image in pixels, at most 2^22 a side. guard: part of the image asked for on each side, 0
// to 1.
// Returns the guard along x and y, for the functions below; 0 along an axis of size below 1. Error: at most 2.5 ulp,
// 5 ulp for sides beyond 2^21 pixels.
// No method or pass here calls it: it is TSSAO, the frame borders, for the engine that renders the band.
vec2 gloam_guard_band_guard(ivec2 size, float guard) {
    return min(vec2(gloam_guard_band_border(size, guard)) / vec2(max(size, ivec2(1))), 1.0);
}

// half field of view with the guard band (TSSAO-BORDER-tan): `tan' = (1 + 2 g) tan` [TSSAO, frame borders].
// tan_half_fov: tangent of half the field of view of the cropped image, along one axis. guard: g of
// gloam_guard_band_guard, that axis.
// Returns the tangent for the image with the band; 0 where it is not finite. Error: at most 3 ulp, above 1e-30.
// No method or pass here calls it: it is TSSAO, the frame borders, for the engine that renders the band.
float gloam_guard_band_tan_half_fov(float tan_half_fov, float guard) {
    float wider = tan_half_fov * (1.0 + 2.0 * guard);
    return gloam_is_finite(wider) ? wider : 0.0;
}

#endif
