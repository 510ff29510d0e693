// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_AKSOY_PHANEUF_GLSL
#define GLOAM_METHODS_AKSOY_PHANEUF_GLSL

#include "gloam/occlusion/aksoy_phaneuf.glsl"
#include "gloam/occlusion/tap_gather.glsl"
#include "gloam/sampling/halton_disc.glsl"

// Surface points under a disc, each counting by its distance if it lies in front of the tangent plane (Aksoy and Phaneuf 2011; CS-J).

vec2 gloam_method_tap(uint i, vec3 position, GloamKernel kernel, vec2 turn) {
    return gloam_halton_disc(kernel.first + i + 1u, turn);
}

float gloam_method_tap_occlusion(vec3 offset, vec3 normal, float depth, GloamKernel kernel, GloamMethod method) {
    return gloam_contribution_aksoy_phaneuf(offset, normal, kernel.radius, kernel.bias);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_tap_gather(position, normal, camera, kernel, method);
}

#endif
