// SPDX-License-Identifier: MIT
#version 450
// Brings the history of the previous frame to the pixels of this one (TSSAO-RP, -7, -8, BUF). What was hidden, outside
// the image or another surface has no history.
#include "passes/study/input_image.glsl"

layout(constant_id = 0) const bool moving_objects = false;  // binding 1 holds the positions; else only the camera moved
// 0: nearest texel, 1: bilinear, valid where the nearest is, 2: bilinear over the valid ones
layout(constant_id = 1) const uint taps = 2u;
layout(constant_id = 3) const bool orthographic = false;           // this frame's camera; else perspective
layout(constant_id = 4) const bool previous_orthographic = false;  // the previous frame's

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT depth_image;
// Where each surface point was, in the view space of the previous frame; read when moving_objects is set.
layout(binding = 1 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT previous_position_image;
// (occlusion, samples accumulated, samples of the sequence used, depth) of the previous frame, and of this frame's
// pixels, with the depth the point had in the previous camera: (0, 0, 0, depth) for none, infinity behind that camera.
layout(binding = 2 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT previous_history;
layout(binding = 3, rgba32f) uniform writeonly highp image2D history;

layout(push_constant) uniform Parameters {
    mat4 previous_from_current;  // view space of this frame to that of the previous one; a rigid motion
    vec2 p00_p11;                // elements [0][0] and [1][1] of this frame's projection, y down
    vec2 previous_p00_p11;       // of the previous frame's
    ivec2 size;                  // of all images, pixels
    float depth_tolerance;       // of the depth test, relative; infinity: no test
} parameters;

#include "gloam/geometry/reprojection.glsl"
#include "gloam/temporal/reprojected_history.glsl"

vec4 gloam_fetch_history(ivec2 pixel) {
    return GLOAM_FETCH(previous_history, pixel);
}

GloamHistory reprojected(ivec2 pixel) {
    float depth = GLOAM_FETCH(depth_image, pixel).x;
    if (gloam_is_background(depth)) return gloam_history_empty(depth);
    GloamCamera camera = GloamCamera(parameters.p00_p11, parameters.size, orthographic);
    GloamCamera before = GloamCamera(parameters.previous_p00_p11, parameters.size, previous_orthographic);
    vec3 previous = gloam_previous_view(pixel, depth, camera, parameters.previous_from_current);
    if (moving_objects) previous = GLOAM_FETCH(previous_position_image, pixel).xyz;
    return gloam_reprojected_point(previous, before, taps, parameters.depth_tolerance);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    imageStore(history, pixel, gloam_history_pack(reprojected(pixel)));
}
