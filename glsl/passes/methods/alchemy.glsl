// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_ALCHEMY_GLSL
#define GLOAM_METHODS_ALCHEMY_GLSL

#include "gloam/occlusion/alchemy.glsl"
#include "gloam/occlusion/tap_gather.glsl"
#include "gloam/sampling/halton_disc.glsl"

// Alchemy ambient obscurance (McGuire et al. 2011; CS-3.6 to 3.10): surface points under a disc, each of which counts 2 sigma (v . n - bias)
// / (v . v + epsilon^2). Its falloff is 0 for touching geometry, rises to the distance sigma and falls as its inverse beyond.
// Reads epsilon (here small: it bounds what one tap counts) and intensity: sigma as a share of the radius.

vec2 gloam_method_tap(uint i, vec3 position, GloamKernel kernel, vec2 turn) {
    return gloam_halton_disc(kernel.first + i + 1u, turn);
}

float gloam_method_tap_occlusion(vec3 offset, vec3 normal, float depth, GloamKernel kernel, GloamMethod method) {
    float sigma = method.intensity * kernel.radius;
    return 2.0 * sigma * gloam_contribution_alchemy(offset, normal, kernel.bias, method.epsilon * method.epsilon);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_tap_gather(position, normal, camera, kernel, method);
}

#endif
