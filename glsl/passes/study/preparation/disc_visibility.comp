// SPDX-License-Identifier: MIT
#version 450
// Visibility of each pixel's disc, for disc_proxy_two (Bunnell, GPU Gems 2). Reads intensity: factor of
// the sum. Writes 1 minus the occlusion by all discs in x; 1 at the background and where the radius is too small.

#include "passes/study/preparation/pass.glsl"
#include "gloam/methods/disc_proxy_two.glsl"

vec3 gloam_fetch_normal(ivec2 pixel) {
    return GLOAM_FETCH(normal_image, pixel).xyz;
}

float prepared(ivec2 pixel) {
    float depth = gloam_fetch_depth(pixel);
    if (gloam_is_background(depth) || below_limit(depth)) return 1.0;
    GloamCamera camera = this_camera();
    vec3 position = gloam_camera_position(pixel, depth, camera);
    GloamKernel kernel = gloam_disc_pass_kernel(kernel_at(pixel));
    GloamDiscProxy settings = GloamDiscProxy(method_values.intensity);
    return 1.0 - gloam_disc_proxy(position, gloam_fetch_normal(pixel), camera, kernel, settings).occlusion;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x < parameters.size.x && pixel.y < parameters.size.y)
        imageStore(prepared_image, pixel, vec4(prepared(pixel)));
}
