// SPDX-License-Identifier: MIT
#version 450
// Computes for each sample what all pixels share: its point of the Halton sequence and the mapped position of this
// point. One invocation a sample.
//
// Dispatch ceil((last - first + 1) / 64) groups. Descriptor set 0:
//   0  rgba32f  written: the samples first to last (samples/table.glsl), 0 in w
layout(local_size_x = 64) in;

layout(binding = 0, rgba32f) uniform writeonly highp image2D table_image;

layout(push_constant) uniform Parameters {
    uint first;  // number of a sample, 1 for the first
    uint last;
} parameters;

#include "samples/table.glsl"

// The shared part of a method's samples: any file of the folder, and its function.
#include "gloam/sampling/hemisphere_cosine_point.glsl"
#ifndef SAMPLE_POINT
#define SAMPLE_POINT gloam_hemisphere_cosine_point
#endif

void main() {
    uint index = parameters.first + gl_GlobalInvocationID.x;
    if (index > parameters.last) return;
    imageStore(table_image, sample_table_texel(index), vec4(SAMPLE_POINT(index), 0.0));
}
