// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_SLICE_SAMPLE_GLSL
#define GLOAM_SAMPLING_SLICE_SAMPLE_GLSL

#include "gloam/numeric/constants.glsl"
#include "gloam/numeric/sincos.glsl"
#include "gloam/sampling/halton_point.glsl"

// What is random of a slice.
struct GloamSliceSample {
    vec2 direction;  // unit, in the image; half a turn of directions makes all slices, the other half is their other
                     // side
    float jitter;    // part of a step, [0, 1)
    float share;     // [0, 1), for what else a method needs
};

// Turns that a kernel's angle stands for.
// angle: radians, |angle| <= 65536; anything else counts as 0. Returns turns. Error: 1 ULP.
float gloam_kernel_turns(float angle) {
    return abs(angle) <= 65536.0 ? angle / GLOAM_TAU : 0.0;
}

// Slice number `index` of the sequence, 1 for the first.
// turns: of gloam_kernel_turns. Error: 5e-7.
GloamSliceSample gloam_slice_sample(uint index, float turns) {
    vec3 point = gloam_halton_point(index);
    return GloamSliceSample(gloam_sincos_turns(0.5 * fract(point.x + turns)), fract(point.y + turns), point.z);
}

#endif
