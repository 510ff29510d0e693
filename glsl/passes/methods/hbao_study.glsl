// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_HBAO_STUDY_GLSL
#define GLOAM_METHODS_HBAO_STUDY_GLSL

// Steps of one length.
#define GLOAM_SLICE_STEP(share) (share)

#include "gloam/occlusion/hbao.glsl"
#include "gloam/occlusion/slice_gather.glsl"

#define GLOAM_METHOD_SAMPLES(count, method) gloam_slice_samples(count, method.steps)

// Horizon-based ambient occlusion as the comparative study has it (Aalund and Baerentzen 2013, after Bavoil and Sainz 2008; CS-C): each march
// begins at tan t + tan bias, in even steps up to the radius; what the bias takes off is not given back. A floor seen at a slant keeps what
// stands on it, where hbao.glsl adds angles and sees nothing from 72 degrees on.
// Reads angle_bias, intensity (contrast) and steps.

vec3 gloam_method_slice_view(vec3 eye) {
    return vec3(0.0, 0.0, 1.0);
}

// tan t of the tangent plane in a direction of the image; as far as gloam_tangent_slope has it.
float gloam_study_slope(vec3 normal, vec2 direction) {
    return clamp(-dot(normal.xy, direction) / max(normal.z, 1e-6), -1e6, 1e6);
}

GloamMarch gloam_method_slice_start(GloamSlice slice, vec3 normal, float share, GloamMethod method) {
    float slope = gloam_study_slope(normal, slice.tangent.xy);
    return GloamMarch(gloam_hbao_start_slope(slope, method.angle_bias), gloam_hbao_start_slope(-slope, method.angle_bias), share, 0u);
}

GloamMarch gloam_method_slice_step(GloamMarch march, GloamSlice slice, vec3 offset, bool positive, GloamKernel kernel,
                                   GloamMethod method) {
    if (positive) {
        march.positive = gloam_hbao_step(march.positive, offset, kernel.radius);
    } else {
        march.negative = gloam_hbao_step(march.negative, offset, kernel.radius);
    }
    return march;
}

float gloam_method_slice_ball(GloamMarch march, bool positive) {
    return 1.0;
}

bool gloam_method_slice_full(GloamMarch march) {
    return false;
}

vec2 gloam_method_slice_end(vec2 accumulated, GloamMarch march, GloamSlice slice, GloamMethod method) {
    float occlusion = 0.5 * (march.positive.y + march.negative.y);
    return accumulated + vec2(1.0 - gloam_hbao_visibility(occlusion, 0.0, method.intensity), 1.0);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_slice_gather(position, normal, camera, kernel, method);
}

#endif
