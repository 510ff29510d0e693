// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_DISC_GLSL
#define GLOAM_METHODS_DISC_GLSL

#include "gloam/occlusion/fox_compton.glsl"
#include "gloam/occlusion/tap_gather.glsl"
#include "gloam/sampling/halton_disc.glsl"

// Crease shading by the surface points under a disc (TSSAO-2, -12 and -4 with the kernel of TSSAO-13; Fox and Compton 2008). The
// mean over the disc's pixels of cos(s - p, n) min(1, epsilon / |s - p|): a measure of how concave the surface is, which
// looks like occlusion but is not the integral of TSSAO-1, and depends on epsilon, 0.01 to 0.1 of the radius.
// Reads epsilon. A point beyond the radius, or no higher than the bias above the tangent plane, contributes nothing: there noise
// would decide.

vec2 gloam_method_tap(uint i, vec3 position, GloamKernel kernel, vec2 turn) {
    return gloam_halton_disc(kernel.first + i + 1u, turn);
}

float gloam_method_tap_occlusion(vec3 offset, vec3 normal, float depth, GloamKernel kernel, GloamMethod method) {
    bool inside = dot(offset, gloam_safe_normalize(offset, vec3(0.0))) <= kernel.radius;
    bool above = dot(offset, normal) > kernel.bias;
    return inside && above ? gloam_contribution_fox_compton_scaled(vec3(0.0), normal, offset, method.epsilon) : 0.0;
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_tap_gather(position, normal, camera, kernel, method);
}

#endif
