// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_TANGENT_SPHERE_GLSL
#define GLOAM_METHODS_TANGENT_SPHERE_GLSL

#include "gloam/occlusion/pair_gather.glsl"
#include "gloam/occlusion/volumetric.glsl"

// Volumetric obscurance of the ball of half the radius that touches the surface from outside (Szirmay-Kalos et al. 2009): a plane leaves
// it empty.

// What one tap contributes, weighted by its chord.
vec2 gloam_tangent_sphere_tap(vec3 offset, vec3 normal, float radius) {
    float weight = gloam_tangent_sphere_half_height(offset, normal, radius);
    return weight * vec2(gloam_tangent_sphere_occlusion(offset, normal, radius), 1.0);
}

vec2 gloam_method_pair_occlusion(GloamPair pair, GloamKernel kernel, GloamMethod method) {
    return gloam_tangent_sphere_tap(pair.first, pair.normal, kernel.radius) +
           gloam_tangent_sphere_tap(pair.second, pair.normal, kernel.radius);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_pair_gather(position, normal, camera, kernel, method);
}

#endif
