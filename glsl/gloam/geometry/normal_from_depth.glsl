// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_NORMAL_FROM_DEPTH_GLSL
#define GLOAM_GEOMETRY_NORMAL_FROM_DEPTH_GLSL

#include "gloam/gather/fetch.glsl"
#include "gloam/geometry/normal.glsl"
#include "gloam/geometry/position.glsl"

// position read from the depth image (POSITION-depth): `POSITION-perspective of the depth and the centre of the pixel`
// [inverse of the projection].
// pixel: integer pixel. size: image size in pixels. p00_p11: projection elements (see gloam_view_position_perspective).
// Returns the position in world units; the zero vector for background and outside the image, where nothing is fetched.
// Error: at most 4 ulp in each component.
vec3 gloam_position_from_depth(ivec2 pixel, ivec2 size, vec2 p00_p11) {
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.x || pixel.y >= size.y) return vec3(0.0);
    return gloam_view_position_perspective(gloam_ndc_from_pixel(pixel, size), gloam_fetch_depth(pixel), p00_p11);
}

// normal reconstructed from the depth image (NORMAL-depth): `NORMAL of the positions under the pixel and its
// neighbours` [definition; one-sided differences as in Bavoil and Sainz 2009].
// View-space normal reconstructed from the depth image, perspective: gloam_normal_from_neighbors on the four
// neighbours. At the image's edges and beside background only the other side is used.
// pixel: integer pixel, taken to the nearest one of the image. size: image size in pixels, from 1 x 1.
// p00_p11: projection elements (see gloam_view_position_perspective).
// Returns a unit vector facing the eye; (0, 0, 1) where the neighbours do not suffice (a single row, column or
// pixel); the zero vector for background. Error: that of the positions, 1e-7 of the distance, over their spacing:
// 2e-5 where it is a fiftieth.
vec3 gloam_normal_from_depth(ivec2 pixel, ivec2 size, vec2 p00_p11) {
    ivec2 at = clamp(pixel, ivec2(0), max(size - 1, ivec2(0)));
    return gloam_normal_from_neighbors(gloam_position_from_depth(at, size, p00_p11),
                                       gloam_position_from_depth(at - ivec2(1, 0), size, p00_p11),
                                       gloam_position_from_depth(at + ivec2(1, 0), size, p00_p11),
                                       gloam_position_from_depth(at - ivec2(0, 1), size, p00_p11),
                                       gloam_position_from_depth(at + ivec2(0, 1), size, p00_p11));
}

#endif
