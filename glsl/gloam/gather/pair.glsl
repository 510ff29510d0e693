// SPDX-License-Identifier: MIT
#ifndef GLOAM_GATHER_PAIR_GLSL
#define GLOAM_GATHER_PAIR_GLSL

#include "gloam/gather/fetch.glsl"
#include "gloam/gather/footprint.glsl"
#include "gloam/geometry/height_at.glsl"
#include "gloam/occlusion/gather_kernel.glsl"

// Two opposite surface points at a time (CS-I, CS-P): if one of them is unusable, the other one represents both. The
// surface at a tap is moved parallel to the tangent plane onto the line along the view vector through the aimed
// position. Opposite taps of a bare plane are then opposite at any tilt, and at the border of the image.

// Background counts as a surface this many radii behind the shaded point.
const float GLOAM_PAIR_FAR = 1e4;

// Height of a tap's surface over an aimed position, along the view vector (gloam_height_at).
// tap: of the unit disc, y as in the image. position, normal: of the shaded point, unit normal. facing: view . normal,
// at least 1e-4.
// Returns a length in world units. Error: 3e-7 of the offset over the facing, but for taps within rounding of a pixel's
// border.
float gloam_pair_height(GloamFootprint footprint, vec2 tap, vec3 aim, vec3 position, vec3 normal, float facing,
                        float radius) {
    ivec2 pixel = gloam_footprint_pixel(footprint, tap);
    float depth = gloam_fetch_depth(pixel);
    float known = gloam_tap_sees(depth) ? depth : GLOAM_PAIR_FAR * radius - position.z;
    return gloam_height_at(gloam_footprint_position(footprint, pixel, known) - position, aim, normal, facing);
}

#endif
