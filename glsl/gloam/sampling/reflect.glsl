// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_REFLECT_GLSL
#define GLOAM_SAMPLING_REFLECT_GLSL

#include "gloam/geometry/safe_normalize.glsl"

// sample reflected at a random plane (REFLECT): `s - 2 (s . n) n, n = normalize(2 t - 1)` [Mittring 2007].
// Mittring's kernel rotation.
// s: sample point in any space, in units of the kernel radius (length below 1e19).
// encoded: texel of a random texture, each channel in [0, 1], that stands for the direction 2 encoded - 1 of any
// length.
// Returns s reflected, of the same length; s itself where 2 encoded - 1 is zero (a grey texel) or not finite; the zero
// vector for a longer, infinite or NaN s. Error: 16 ulp of the largest component, while that is above 1e-30; shorter
// vectors may be flushed to 0.
// No method or pass here calls it: it is the reflection of the comparative study; the methods rotate.
vec3 gloam_reflect_sample(vec3 s, vec3 encoded) {
    if (!(dot(s, s) <= 1e38)) return vec3(0.0);
    vec3 n = gloam_safe_normalize(2.0 * encoded - 1.0, vec3(0.0));
    float squared = dot(n, n);
    if (!(squared > 0.5)) return s;
    // Division by n . n, which is 1 but for rounding, keeps the length of s.
    return s - (2.0 * dot(s, n) / squared) * n;
}

#endif
