// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_ANGLE_GLSL
#define GLOAM_METHODS_ANGLE_GLSL

#include "gloam/numeric/inverse_trigonometry.glsl"
#include "gloam/occlusion/angle_based.glsl"
#include "gloam/occlusion/pair_gather.glsl"

#define GLOAM_METHOD_SAMPLES(count, method) gloam_paired_samples(count)

// Angles between opposite samples, as in Unreal Engine 4 (Mittring 2012; CS-P). Neither cosine-weighted nor uniform.
// Reads range (samples nearer to the eye than that are other objects) and angle_bias, here taken off the cosines.

vec2 gloam_method_pair_occlusion(GloamPair pair, GloamKernel kernel, GloamMethod method) {
    vec3 cosines = gloam_angle_pair(pair.first, pair.second, pair.normal, pair.view, method.range);
    float angles = gloam_acos(cosines.x - method.angle_bias) + gloam_acos(cosines.y - method.angle_bias);
    return gloam_angle_add(vec2(0.0), cosines.z, angles);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_pair_gather(position, normal, camera, kernel, method);
}

#endif
