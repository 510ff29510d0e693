// SPDX-License-Identifier: MIT
#ifndef GLOAM_GATHER_PAIR_GLSL
#define GLOAM_GATHER_PAIR_GLSL

#include "gloam/gather/fetch.glsl"
#include "gloam/gather/footprint.glsl"
#include "gloam/geometry/vector.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/volumetric.glsl"

// Two opposite surface points at a time (CS-I, CS-P): if one of them is unusable, the other one represents both. The
// surface at a tap is moved parallel to the tangent plane onto the line along the view vector through the aimed
// position. Opposite taps of a bare plane are then opposite at any tilt, and at the border of the image.

// Background counts as a surface this many radii behind the shaded point.
const float GLOAM_PAIR_FAR = 1e4;

// The data of the shaded point, the same for all its pairs.
struct GloamLinePoint {
    vec3 position;  // view space, world units
    vec3 normal;    // unit
    vec3 view;      // from the point to the eye, unit
    float facing;   // cosine between the normal and the direction to the eye, at least 1e-4
    vec2 upright;   // gloam_upright
    GloamFootprint footprint;
};

// Computed once a pixel; requires gloam_can_gather.
// position: of the surface, view space, world units. normal: unit. radius: of influence, world units.
// Error of the facing: 1e-6.
GloamLinePoint gloam_line_point(vec3 position, vec3 normal, float radius, GloamCamera camera) {
    vec3 view = gloam_toward_eye(position, camera.orthographic);
    return GloamLinePoint(position, normal, view, max(dot(view, normal), 1e-4), gloam_upright(camera),
                          gloam_footprint(position, radius, camera));
}

// Height of a tap's surface over an aimed position, along the view vector (gloam_height_at).
// tap: of the unit disc, y as in the image.
// Returns a length in world units. Error: 3e-7 of the offset over the facing, but for taps within rounding of a pixel's
// border.
float gloam_pair_height(GloamLinePoint point, vec2 tap, vec3 aim, float radius) {
    ivec2 pixel = gloam_footprint_pixel(point.footprint, tap);
    float depth = gloam_fetch_depth(pixel);
    float known = gloam_tap_sees(depth) ? depth : GLOAM_PAIR_FAR * radius - point.position.z;
    vec3 offset = gloam_footprint_position(point.footprint, pixel, known) - point.position;
    return gloam_height_at(offset, aim, point.normal, point.facing);
}

// What a pair of chords contributes: two opposite line samples of volumetric obscurance (CS-3.5). If one of them is
// unusable, the other one replaces it.
struct GloamPairShare {
    float occluded;  // solid length
    float whole;     // length
};

// Solid lengths of the chords of the ball at a tap and at the opposite tap.
// tap: of the unit disc, y as in the image. kernel: only its radius is used.
// Returns both chords' lengths as `whole`, and their solid part as `occluded`. Error: that of gloam_pair_height and
// gloam_line_pair times the chord, except for taps within rounding of a pixel's border.
GloamPairShare gloam_line_pair_share(GloamLinePoint point, vec2 tap, GloamKernel kernel) {
    vec3 aim = vec3(kernel.radius * tap * point.upright, 0.0);
    float half_height = gloam_chord_half_height(tap, kernel.radius);
    float first = gloam_pair_height(point, tap, aim, kernel.radius);
    float second = gloam_pair_height(point, -tap, -aim, kernel.radius);
    vec2 ratios = vec2(gloam_line_ratio(first, half_height), gloam_line_ratio(second, half_height));
    vec2 solid = gloam_line_pair(ratios, 0.35, 1.0);  // as the published shader has it
    return GloamPairShare(half_height * (solid.x + solid.y), 2.0 * half_height);
}

#endif
