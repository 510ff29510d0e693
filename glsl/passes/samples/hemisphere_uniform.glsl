// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLES_HEMISPHERE_UNIFORM_GLSL
#define GLOAM_SAMPLES_HEMISPHERE_UNIFORM_GLSL

#include "gloam/sampling/halton.glsl"
#include "gloam/sampling/hemisphere.glsl"

// As in hemisphere_cosine.glsl.
#ifndef GLOAM_SHARED_SAMPLE
#define GLOAM_SHARED_SAMPLE gloam_shared_sample
#endif

// Point of the half ball, uniform in direction and radius.
// index: number of the Halton point, 1 for the first. Returns the point in tangent space, z along the normal.
vec3 gloam_shared_sample(uint index) {
    return gloam_hemisphere_uniform(gloam_halton_3d(index));
}

#endif
