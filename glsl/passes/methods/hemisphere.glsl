// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_HEMISPHERE_GLSL
#define GLOAM_METHODS_HEMISPHERE_GLSL

#include "gloam/occlusion/blocked.glsl"
#include "gloam/occlusion/point_gather.glsl"
#include "gloam/occlusion/ritschel.glsl"
#include "gloam/sampling/rotation.glsl"
#include "passes/samples/hemisphere_cosine.glsl"

// Ambient occlusion by points in the half ball above the surface (TSSAO-2, -3 and -4 with the kernel of TSSAO-14; Ritschel et
// al. 2009). Cosine-weighted directions of uniform radius need neither cosine nor falloff: the mean of the plain blocked
// tests estimates TSSAO-1 with the linear falloff, for a scene that is solid behind what the eye sees.
// Reads range, about the radius, or infinity.

vec3 gloam_method_point(uint index, vec2 turn) {
    return gloam_turn_hemisphere(GLOAM_SHARED_SAMPLE(index), turn);
}

float gloam_method_point_occlusion(float depth, float buffer_depth, GloamKernel kernel, GloamMethod method) {
    return gloam_contribution_cosine_directions(gloam_sample_blocked(depth, buffer_depth, kernel.bias, method.range), 1.0);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_point_gather(position, normal, camera, kernel, method);
}

#endif
