// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_CRYTEK_GLSL
#define GLOAM_METHODS_CRYTEK_GLSL

#include "gloam/occlusion/crytek.glsl"
#include "gloam/occlusion/point_gather.glsl"
#include "gloam/sampling/rotation.glsl"
#include "passes/samples/hemisphere_uniform.glsl"

// Crytek's method (Mittring 2007; CS-3.1): points of a whole ball, without falloff. On a plane half of the ball lies in the ground: points
// come in opposite pairs, so a bare plane reads exactly 1/2 for an even number of them. The remap's a = 0.5 undoes it.

vec3 gloam_method_point(uint index, vec2 turn) {
    vec3 point = gloam_turn_hemisphere(GLOAM_SHARED_SAMPLE((index + 1u) / 2u), turn);
    return (index & 1u) == 1u ? point : -point;
}

// The bias opens the points that lie less than it behind the surface. Left at 0, opposite points of a plane differ.
float gloam_method_point_occlusion(float depth, float buffer_depth, GloamKernel kernel, GloamMethod method) {
    return gloam_contribution_crytek(depth - kernel.bias, buffer_depth);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_point_gather(position, normal, camera, kernel, method);
}

#endif
