// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_AKSOY_PHANEUF_TWO_GLSL
#define GLOAM_METHODS_AKSOY_PHANEUF_TWO_GLSL

#include "gloam/occlusion/aksoy_phaneuf.glsl"
#include "gloam/occlusion/tap_gather.glsl"
#include "gloam/sampling/halton_disc.glsl"

// aksoy_phaneuf at two radii (Aksoy and Phaneuf 2011; CS-J): half of the samples within a quarter of the radius, for fine detail, half within
// the whole; both are added and the sum clamped. (The larger of the two would depend on the noise of a frame's few samples.)

// The fine radius, as a share of the other.
const float GLOAM_FINE_SHARE = 0.25;

vec2 gloam_method_tap(uint i, vec3 position, GloamKernel kernel, vec2 turn) {
    return gloam_halton_disc(kernel.first + i + 1u, turn);
}

float gloam_method_tap_occlusion(vec3 offset, vec3 normal, float depth, GloamKernel kernel, GloamMethod method) {
    return gloam_contribution_aksoy_phaneuf(offset, normal, kernel.radius, kernel.bias);
}

// As many at both radii.
uint gloam_two_radii_samples(uint count) {
    return count + (count & 1u);
}
#define GLOAM_METHOD_SAMPLES(count, method) gloam_two_radii_samples(count)

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    uint half_count = gloam_two_radii_samples(kernel.count) / 2u;
    GloamKernel broad = GloamKernel(kernel.radius, kernel.bias, kernel.angle, kernel.first / 2u, half_count);
    GloamKernel fine = broad;
    fine.radius = GLOAM_FINE_SHARE * kernel.radius;
    vec2 far = gloam_tap_gather(position, normal, camera, broad, method);
    vec2 near = gloam_tap_gather(position, normal, camera, fine, method);
    if (!(far.y > 0.0)) return vec2(0.0);
    float occlusion = gloam_two_radii_sum(gloam_estimator_mean(near), gloam_estimator_mean(far));
    return float(2u * half_count) * vec2(occlusion, 1.0);
}

#endif
