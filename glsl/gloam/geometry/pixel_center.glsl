// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_PIXEL_CENTER_GLSL
#define GLOAM_GEOMETRY_PIXEL_CENTER_GLSL

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
// Pixel whose centre is nearest to a texture coordinate, for fetches that must not interpolate (TSSAO-7: the start
// index and the depth of the history): floor(uv resolution), kept inside the image.
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

#endif
