// SPDX-License-Identifier: MIT
#ifndef GLOAM_PREPARATION_DIRECTIONS_GLSL
#define GLOAM_PREPARATION_DIRECTIONS_GLSL

// The two directions of the image, across each other, of which one frame sees a slice each.

#define gloam_method_gather gloam_slices_gather
#include "passes/methods/gtao.glsl"
#undef gloam_method_gather

// Taps to each side of a slice: each of both slices has half of the samples.
uint gloam_pair_steps(GloamKernel kernel) {
    return max(kernel.count / 4u, 1u);
}

// Samples that are taken where `count` are asked for: both slices' taps.
uint gloam_separable_samples(uint count) {
    return 4u * max(count / 4u, 1u);
}
#undef GLOAM_METHOD_SAMPLES
#define GLOAM_METHOD_SAMPLES(count, method) gloam_separable_samples(count)

// The samples of one slice; the directions turn from frame to frame.
// second: the slice across the first. Half a turn of the kernel is a quarter of one of the slices.
GloamKernel gloam_pair_kernel(GloamKernel kernel, bool second) {
    uint frame = kernel.first / gloam_separable_samples(kernel.count);
    uint taps = 2u * gloam_pair_steps(kernel);
    return GloamKernel(kernel.radius, kernel.bias, kernel.angle + (second ? 3.141592654 : 0.0), frame * taps, taps);
}

// Direction of a slice in the image, unit, y down, as gloam_slice_gather has it.
vec2 gloam_pair_direction(GloamKernel kernel, bool second) {
    GloamKernel one = gloam_pair_kernel(kernel, second);
    return gloam_circle_point(0.5 * fract(gloam_radical_inverse_base2(one.first / one.count + 1u) + one.angle / 6.283185307));
}

// Occlusion of a slice, cosine-weighted.
float gloam_pair_occlusion(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method, bool second) {
    method.steps = gloam_pair_steps(kernel);
    return gloam_estimator_mean(gloam_slices_gather(position, normal, camera, gloam_pair_kernel(kernel, second), method));
}

#endif
