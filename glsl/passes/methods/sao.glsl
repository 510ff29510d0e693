// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_SAO_GLSL
#define GLOAM_METHODS_SAO_GLSL

#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/sao.glsl"
#include "gloam/sampling/radical_inverse.glsl"
#include "gloam/sampling/spiral.glsl"

// Scalable ambient obscurance (McGuire, Mara and Luebke 2012): surface points on a spiral under a disc, dense near the pixel, far ones
// read from a depth chain (mip_distance 16). Each frame turns the spiral by another angle.
// Reads epsilon, mip_distance and intensity: sigma as a share of the radius, which the paper has at 1 m.

vec2 gloam_sao_turn(GloamKernel kernel);
#define GLOAM_KERNEL_TURN gloam_sao_turn
#include "gloam/occlusion/tap_gather.glsl"

const int GLOAM_SAO_TURNS = 7;

// (cos, sin) of the pixel's angle and the frame's.
vec2 gloam_sao_turn(GloamKernel kernel) {
    uint frame = kernel.first / max(kernel.count, 1u);
    return gloam_sincos(kernel.angle + 6.283185307 * gloam_radical_inverse_base2(frame));
}

vec2 gloam_method_tap(uint i, vec3 position, GloamKernel kernel, vec2 turn) {
    return gloam_turn_disc(gloam_spiral_point(int(i), int(kernel.count), GLOAM_SAO_TURNS), turn);
}

float gloam_method_tap_occlusion(vec3 offset, vec3 normal, float depth, GloamKernel kernel, GloamMethod method) {
    float sigma = method.intensity * kernel.radius;
    return 5.0 * sigma *
           gloam_contribution_sao(offset, normal, kernel.radius, kernel.bias, method.epsilon * method.epsilon);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_tap_gather(position, normal, camera, kernel, method);
}

#endif
