// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_COSINE_GLSL
#define GLOAM_OCCLUSION_COSINE_GLSL

#include "gloam/geometry/safe_normalize.glsl"

// clamped cosine of a sample's angle to the normal (TSSAO-1-cos): `max((s - p) . n / |s - p|, 0)` [TSSAO,
// eq 1 with the clamp it lacks in print].
// offset: s - p, any space and unit. normal: unit vector, same space.
// Returns a cosine in [0, 1]; 0 for an offset that is zero, subnormal, infinite or NaN, and for a NaN normal.
// Error: 3e-7.
float gloam_sample_cosine(vec3 offset, vec3 normal) {
    float cosine = dot(gloam_safe_normalize(offset, vec3(0.0)), normal);
    return cosine > 0.0 ? (cosine < 1.0 ? cosine : 1.0) : 0.0;
}

#endif
