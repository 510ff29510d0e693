// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLES_HEMISPHERE_COSINE_GLSL
#define GLOAM_SAMPLES_HEMISPHERE_COSINE_GLSL

#include "gloam/sampling/halton.glsl"
#include "gloam/sampling/hemisphere.glsl"

// What is the same for all pixels of a sample, which only its number tells apart. A pass that has it in a table (table.glsl) defines
// GLOAM_SHARED_SAMPLE as what reads it, before it includes this file.
#ifndef GLOAM_SHARED_SAMPLE
#define GLOAM_SHARED_SAMPLE gloam_shared_sample
#endif

// Point of the half ball, cosine-weighted directions of uniform radius (TSSAO-14).
// index: number of the Halton point, 1 for the first. Returns the point in tangent space, z along the normal.
vec3 gloam_shared_sample(uint index) {
    return gloam_hemisphere_cosine(gloam_halton_3d(index));
}

#endif
