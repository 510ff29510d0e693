// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_SLICE_SAMPLE_GLSL
#define GLOAM_SAMPLING_SLICE_SAMPLE_GLSL

#include "gloam/numeric/sincos.glsl"
#include "gloam/sampling/halton_point.glsl"

// What is random of a slice.
struct GloamSliceSample {
    vec2 direction;  // unit, in the image; half a turn of directions makes all slices, the other half is their other
                     // side
    float jitter;    // part of a step, [0, 1)
    float share;     // [0, 1), for what else a method needs
};

// what is random of a slice (SLICE-sample): `direction pi fract(x + t), jitter fract(y + t), share z, of the Halton
// point (x, y, z)` [GTAO (Jimenez et al. 2016) with the sequence of TSSAO].
// Slice number `index` of the sequence, 1 for the first.
// turns: by which the kernel is rotated (gloam_turns of its angle). Error: 5e-7.
GloamSliceSample gloam_slice_sample(uint index, float turns) {
    vec3 point = gloam_halton_point(index);
    return GloamSliceSample(gloam_sincos_turns(0.5 * fract(point.x + turns)), fract(point.y + turns), point.z);
}

#endif
