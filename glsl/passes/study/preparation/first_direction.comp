// SPDX-License-Identifier: MIT
#version 450
// Occlusion along the first of two directions, for separable.glsl (Huang et al. 2011). Writes the occlusion in
// x, 0 at the background.

#include "passes/study/preparation/pass.glsl"
#include "gloam/methods/separable.glsl"

float prepared(ivec2 pixel) {
    float depth = gloam_fetch_depth(pixel);
    if (gloam_is_background(depth) || below_limit(depth)) return 0.0;
    GloamCamera camera = this_camera();
    vec3 position = gloam_camera_position(pixel, depth, camera);
    return gloam_separable_slice(position, GLOAM_FETCH(normal_image, pixel).xyz, camera, kernel_at(pixel), false);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x < parameters.size.x && pixel.y < parameters.size.y)
        imageStore(prepared_image, pixel, vec4(prepared(pixel)));
}
