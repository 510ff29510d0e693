// SPDX-License-Identifier: MIT
#version 450
// Occlusion at half the resolution, for dual_resolution.glsl (Bavoil and Sainz 2009): one invocation for each 2 x 2
// pixels. Writes (occlusion of the pixel at the upper left of the four, its normal): occlusion 0 at the background.

#include "passes/study/preparation/pass.glsl"
#include "gloam/methods/dual_resolution.glsl"

// Distance in pixels up to which a pixel of the frame reads its neighbourhood of 3 x 3 half-resolution pixels.
const int REACH = 4;

vec4 prepared(ivec2 pixel) {
    float depth = gloam_fetch_depth(pixel);
    if (gloam_is_background(depth) || far_from_frame(pixel, REACH)) return vec4(0.0);
    vec3 normal = GLOAM_FETCH(normal_image, pixel).xyz;
    if (below_limit(depth)) return vec4(0.0, normal);
    GloamCamera camera = this_camera();
    vec3 position = gloam_camera_position(pixel, depth, camera);
    GloamDualResolution settings = GloamDualResolution(method_values.angle_bias, method_values.intensity, method_steps,
                                                       method_values.disagreement, layers);
    return vec4(gloam_dual_horizons(position, normal, camera, kernel_at(pixel), settings).occlusion, normal);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = gloam_half_size(parameters.size);
    if (pixel.x < size.x && pixel.y < size.y) imageStore(prepared_image, pixel, prepared(gloam_half_source(pixel)));
}
