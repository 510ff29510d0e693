// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_PIXEL_GLSL
#define GLOAM_GEOMETRY_PIXEL_GLSL

#include "gloam/geometry/background.glsl"

// pixel of a texture coordinate along one axis (TSSAO-7-index): `floor(u resolution), inside the image` [TSSAO, eq 7].
// u: texture coordinate. resolution: pixels along the axis, at most 2^24.
// Returns an index in [0, resolution - 1]: the nearer end for a coordinate outside [0, 1) (1 is the last pixel), 0
// for NaN and for a resolution below 1. A coordinate within rounding of a pixel border may fall to either side.
int gloam_nearest_index(float u, int resolution) {
    int last = max(resolution, 1) - 1;
    float scaled = u * float(resolution);
    return scaled >= 1.0 ? (scaled < float(last) ? int(scaled) : last) : 0;
}

// pixel of a texture coordinate (TSSAO-7-pixel): `floor(uv resolution), inside the image` [TSSAO, eq 7].
// For fetches that must not interpolate: the start index and the depth of the history.
// uv: texture coordinates, [0, 1]^2 inside the image. resolution: image size in pixels, at most 2^24 a side.
// Returns integer pixel coordinates inside the image: the nearest pixel for coordinates outside, 0 for NaN. A
// coordinate within rounding of a pixel border may fall to either side.
ivec2 gloam_nearest_pixel(vec2 uv, ivec2 resolution) {
    return ivec2(gloam_nearest_index(uv.x, resolution.x), gloam_nearest_index(uv.y, resolution.y));
}

// pixel centre of a texture coordinate (TSSAO-7): `(floor(uv resolution) + 1/2) / resolution` [TSSAO, eq 7 corrected].
// The brackets of the printed equation are a floor.
// uv: texture coordinates, [0, 1]^2 inside the image. resolution: image size in pixels, at most 2^22 a side.
// Returns a point in (0, 1)^2, its own pixel centre; a resolution below 1 is read as 1. Error: at most 2.5 ulp, for
// the pixel that gloam_nearest_pixel gives.
vec2 gloam_pixel_center(vec2 uv, ivec2 resolution) {
    ivec2 size = max(resolution, ivec2(1));
    return (vec2(gloam_nearest_pixel(uv, size)) + 0.5) / vec2(size);
}

// texture coordinates inside the image (INSIDE): `0 <= u, v <= 1` [convention].
// uv: texture coordinates.
// Returns false if either coordinate is outside, infinite or NaN. Error: none.
bool gloam_inside_unit(vec2 uv) {
    return uv.x >= 0.0 && uv.x <= 1.0 && uv.y >= 0.0 && uv.y <= 1.0;
}

// texture coordinate among the texel centres of an axis (TSSAO-RP-texel): `i + f = u n - 1/2, f in [0, 1), 0 within
// 1/256 of a centre` [definition of texture coordinates].
// u: texture coordinate in [0, 1]. extent: texels of the axis, at least 1.
// Returns (first texel, fraction in [0, 1)): the coordinate lies `fraction` of the way from the centre of the first
// texel to that of the next; -1 at the border before texel 0. Within 1/256 of a centre the fraction is 0:
// reprojection of a camera that stands still is exact to about 1e-6 and must not blur, frame by frame, into the
// neighbours. (0, 0) for u outside [0, 1] or NaN, and for an extent below 1. Error of the fraction: 6e-8 of the
// extent, and as near to 1/256 of a centre it may be taken for 0 or not.
vec2 gloam_texel_position(float u, int extent) {
    bool inside = u >= 0.0 && u <= 1.0 && extent >= 1;
    float position = u * float(extent) - 0.5;
    float first = floor(position);
    float fraction = position - first;
    bool next = fraction > 0.99609375;
    bool between = fraction >= 0.00390625 && !next;
    return inside ? vec2(next ? first + 1.0 : first, between ? fraction : 0.0) : vec2(0.0);
}

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
// The same on opposite sides.
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
// Returns the guard along x and y, for the functions below; 0 along an axis of size below 1. Error: at most 5 ulp,
// 2.5 ulp for sides up to 2^21 pixels.
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
