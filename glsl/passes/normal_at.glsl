// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_NORMAL_AT_GLSL
#define GLOAM_PASSES_NORMAL_AT_GLSL

// The normal of a pixel from the depth of its four neighbours, of either camera. gloam_fetch_depth is defined by what
// includes this.
#include "gloam/geometry/normal_from_depth.glsl"

// Of an orthographic camera; the zero vector for background and outside the image.
vec3 position_at(ivec2 pixel, ivec2 size, vec2 p00_p11) {
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.x || pixel.y >= size.y) return vec3(0.0);
    return gloam_view_position_orthographic(gloam_ndc_from_pixel(pixel, size), gloam_fetch_depth(pixel), p00_p11);
}

// Returns a view-space unit normal that faces the eye; 0 at the background.
vec3 normal_at(ivec2 pixel, ivec2 size, vec2 p00_p11, bool orthographic) {
    if (!orthographic) return gloam_normal_from_depth(pixel, size, p00_p11);
    return gloam_normal_from_neighbors_orthographic(
        position_at(pixel, size, p00_p11), position_at(pixel - ivec2(1, 0), size, p00_p11),
        position_at(pixel + ivec2(1, 0), size, p00_p11), position_at(pixel - ivec2(0, 1), size, p00_p11),
        position_at(pixel + ivec2(0, 1), size, p00_p11));
}

#endif
