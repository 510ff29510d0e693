// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_LENGTH_GLSL
#define GLOAM_GEOMETRY_LENGTH_GLSL

#include "gloam/geometry/safe_normalize.glsl"

// length of a vector of any size (LENGTH-vector): `|v| = v . (v / |v|)` [definition].
// Length of a vector of any size: |v| as the dot product with its own direction, where length() overflows above 1e19
// and underflows below 1e-19.
// v: any vector.
// Returns a length >= 0, in the unit of v; 0 for a vector that is zero, subnormal, infinite or NaN. Error: 4 ulp for
// lengths from 1e-30 to 1e38.
float gloam_length(vec3 v) {
    float along = dot(v, gloam_safe_normalize(v, vec3(0.0)));  // NaN for an infinite v, which max() may return or not
    return along > 0.0 ? along : 0.0;
}

#endif
