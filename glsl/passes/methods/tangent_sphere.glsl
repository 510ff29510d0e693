// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_TANGENT_SPHERE_GLSL
#define GLOAM_METHODS_TANGENT_SPHERE_GLSL

#include "gloam/occlusion/pair_gather.glsl"
#include "gloam/occlusion/volumetric.glsl"
#include "gloam/sampling/tangent_frame.glsl"

#define GLOAM_METHOD_SAMPLES(count, method) gloam_paired_samples(count)

// Volumetric obscurance of the ball of half the radius that touches the surface from outside (Szirmay-Kalos et al. 2009): a plane leaves
// it empty. Chords lie along the view vector: along the axis of a perspective view, a floor that is seen from a camera which looks up would
// lie before its own ball.

// What one tap contributes, weighted by its chord.
// toward_eye: orthonormal, its third column the view vector.
vec2 gloam_tangent_sphere_tap(vec3 offset, vec3 normal, mat3 toward_eye, float radius) {
    vec3 seen = offset * toward_eye;
    vec3 n = normal * toward_eye;
    float weight = gloam_tangent_sphere_half_height(seen, n, radius);
    return weight * vec2(gloam_tangent_sphere_occlusion(seen, n, radius), 1.0);
}

vec2 gloam_method_pair_occlusion(GloamPair pair, GloamKernel kernel, GloamMethod method) {
    mat3 toward_eye = gloam_tangent_frame(pair.view);
    return gloam_tangent_sphere_tap(pair.first, pair.normal, toward_eye, kernel.radius) +
           gloam_tangent_sphere_tap(pair.second, pair.normal, toward_eye, kernel.radius);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_pair_gather(position, normal, camera, kernel, method);
}

#endif
