// SPDX-License-Identifier: MIT
#version 450
// A mean over 3 x 3 pixels that are about as deep, as an engine without this library has it: the denoising after
// plain_slices.comp. For comparison only, as that.
#include "passes/study/input_image.glsl"

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT depth_image;
layout(binding = 1 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT occlusion_image;
layout(binding = 2, r32f) uniform writeonly highp image2D blurred_image;

layout(push_constant) uniform Parameters {
    ivec2 size;       // of the images, pixels
    float tolerance;  // relative difference of depth from which a pixel does not count
} parameters;

const float far = 1e9;  // background is there, world units

float depth_at(ivec2 pixel) {
    return min(GLOAM_FETCH(depth_image, pixel).x, far);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, parameters.size))) return;
    float depth = depth_at(pixel);
    float scale = 1.0 / (parameters.tolerance * depth);
    float sum = GLOAM_FETCH(occlusion_image, pixel).x;
    float whole = 1.0;
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            if (x == 0 && y == 0) continue;
            ivec2 at = clamp(pixel + ivec2(x, y), ivec2(0), parameters.size - 1);
            float weight = max(1.0 - abs(depth_at(at) - depth) * scale, 0.0);
            sum += weight > 0.0 ? weight * GLOAM_FETCH(occlusion_image, at).x : 0.0;
            whole += weight > 0.0 ? weight : 0.0;
        }
    }
    imageStore(blurred_image, pixel, vec4(sum / whole));
}
