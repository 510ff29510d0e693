// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLES_TABLE_GLSL
#define GLOAM_SAMPLES_TABLE_GLSL

// The part of the samples that all pixels share (gloam/sampling/points), in an image of 256 columns: sample number i is
// texel (i mod 256, i / 256). sample_table.comp writes it.
// A pass that reads the table defines GLOAM_SAMPLE_TABLE as its binding, SAMPLE_POINT as the name of the points'
// function, and the include guard of that function's file, so that the table replaces it. The pass includes this file
// before the method.

const uint SAMPLE_TABLE_COLUMNS = 256u;

ivec2 sample_table_texel(uint index) {
    return ivec2(uvec2(index % SAMPLE_TABLE_COLUMNS, index / SAMPLE_TABLE_COLUMNS));
}

#ifdef GLOAM_SAMPLE_TABLE
#include "passes/input_image.glsl"
layout(binding = GLOAM_SAMPLE_TABLE GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT sample_table;

vec3 SAMPLE_POINT(uint index) {
    return GLOAM_FETCH(sample_table, sample_table_texel(index)).xyz;
}
#endif

#endif
