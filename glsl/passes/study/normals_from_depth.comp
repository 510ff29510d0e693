// SPDX-License-Identifier: MIT
#version 450
// Normals from depth, for engines that do not store them, from the four neighbours.
#include "passes/study/input_image.glsl"

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT depth_image;
layout(binding = 1, rgba32f) uniform writeonly highp image2D normal_image;  // unit, 0 at the background; w is 0

layout(push_constant) uniform Parameters {
    vec2 p00_p11;       // elements [0][0] and [1][1] of the projection, y down
    ivec2 size;         // of the images, pixels
    uint orthographic;  // 1, or 0 for perspective
} parameters;

#include "gloam/geometry/camera_normal.glsl"

float gloam_fetch_depth(ivec2 pixel) {
    return GLOAM_FETCH(depth_image, pixel).x;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    GloamCamera camera = GloamCamera(parameters.p00_p11, parameters.size, parameters.orthographic != 0u);
    imageStore(normal_image, pixel, vec4(gloam_camera_normal(pixel, camera), 0.0));
}
