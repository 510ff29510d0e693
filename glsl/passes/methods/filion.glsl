// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_FILION_GLSL
#define GLOAM_METHODS_FILION_GLSL

#include "gloam/occlusion/filion.glsl"
#include "gloam/occlusion/point_gather.glsl"
#include "gloam/sampling/rotation.glsl"
#include "passes/samples/hemisphere_uniform.glsl"

// StarCraft II's method (Filion and McNaughton 2008): points of the half ball, uniform in direction and radius; what lies further in front
// of a point than the radius opens again as radius / distance. Uniform directions: a wall reads 1/2, as with cosine weights, a
// bowl more.

vec3 gloam_method_point(uint index, vec2 turn) {
    return gloam_turn_hemisphere(GLOAM_SHARED_SAMPLE(index), turn);
}

float gloam_method_point_occlusion(float depth, float buffer_depth, GloamKernel kernel, GloamMethod method) {
    return gloam_contribution_filion(depth - kernel.bias, buffer_depth, kernel.radius);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_point_gather(position, normal, camera, kernel, method);
}

#endif
