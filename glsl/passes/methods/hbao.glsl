// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_HBAO_GLSL
#define GLOAM_METHODS_HBAO_GLSL

#include "gloam/occlusion/hbao.glsl"
#include "gloam/occlusion/slice_gather.glsl"

#define GLOAM_METHOD_SAMPLES(count, method) gloam_slice_samples(count, method.steps)

// Horizon-based ambient occlusion (Bavoil and Sainz 2008; CS-3.2 to 3.4): horizons above the image plane, every direction of the hemisphere
// alike, each rise of the horizon weighted by 1 - |v|^2 / R^2. What the bias takes off is given back.
// Reads angle_bias, intensity (contrast) and steps.

vec3 gloam_method_slice_view(vec3 eye) {
    return vec3(0.0, 0.0, 1.0);
}

GloamMarch gloam_method_slice_start(GloamSlice slice, vec3 normal, float share, GloamMethod method) {
    vec2 direction = slice.tangent.xy;
    return GloamMarch(gloam_hbao_start(gloam_tangent_elevation(normal, direction), method.angle_bias),
                      gloam_hbao_start(gloam_tangent_elevation(normal, -direction), method.angle_bias), share, 0u);
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

// Nothing rises above the bias where the tangent plane slopes towards the eye nearly along the view: the sine there is 1.
float gloam_method_slice_ball(GloamMarch march, bool positive) {
    return (positive ? march.positive.x : march.negative.x) < 1.0 ? 1.0 : 0.0;
}

bool gloam_method_slice_full(GloamMarch march) {
    return false;
}

vec2 gloam_method_slice_end(vec2 accumulated, GloamMarch march, GloamSlice slice, GloamMethod method) {
    float occlusion = 0.5 * (march.positive.y + march.negative.y);
    return accumulated + vec2(1.0 - gloam_hbao_visibility(occlusion, method.angle_bias, method.intensity), 1.0);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_slice_gather(position, normal, camera, kernel, method);
}

#endif
