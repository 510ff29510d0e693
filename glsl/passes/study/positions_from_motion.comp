// SPDX-License-Identifier: MIT
#version 450
// Where surface points were in the frame before, from motion vectors. A motion vector says where a point was
// in the image; how far it was from the eye follows from the camera, as if the point itself stood still.
#include "passes/study/input_image.glsl"

layout(constant_id = 0) const bool orthographic = false;           // this frame's camera; else perspective
layout(constant_id = 1) const bool previous_orthographic = false;  // the previous frame's

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT depth_image;
// In xy, in units of motion_unit, any format. Not finite: the point was not in the image.
layout(binding = 1 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT motion_image;
// In the view space of the previous frame; 0 where that is unknown, and at the background.
layout(binding = 2, rgba32f) uniform writeonly highp image2D previous_position_image;

layout(push_constant) uniform Parameters {
    mat4 previous_from_current;  // view space of this frame to that of the previous one
    vec2 p00_p11;                // elements [0][0] and [1][1] of this frame's projection, y down
    vec2 previous_p00_p11;       // of the previous frame's
    ivec2 size;                  // of the images, pixels
    vec2 motion_unit;            // pixels: by how many, x right and y down, a point has moved that has a vector of 1
} parameters;

#include "gloam/geometry/reprojection.glsl"

vec3 earlier(ivec2 pixel, float depth) {
    GloamCamera camera = GloamCamera(parameters.p00_p11, parameters.size, orthographic);
    GloamCamera previous = GloamCamera(parameters.previous_p00_p11, parameters.size, previous_orthographic);
    vec3 still = gloam_previous_view(pixel, depth, camera, parameters.previous_from_current);
    return gloam_previous_moved(pixel, parameters.motion_unit * GLOAM_FETCH(motion_image, pixel).xy, still, previous);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    float depth = GLOAM_FETCH(depth_image, pixel).x;
    vec3 position = gloam_is_background(depth) ? vec3(0.0) : earlier(pixel, depth);
    imageStore(previous_position_image, pixel, vec4(position, 0.0));
}
