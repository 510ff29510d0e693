// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_SAFE_NORMALIZE_GLSL
#define GLOAM_GEOMETRY_SAFE_NORMALIZE_GLSL

#include "gloam/geometry/finite.glsl"
#include "gloam/numeric/constants.glsl"

// unit vector along any vector that has a direction (NORMALIZE): `v / |v|; the fallback where v is zero, infinite or
// NaN` [definition].
// Unit vector along v for every v that has a direction: v / |v|, where normalize() overflows above 1e19 and
// underflows below 1e-19.
// v: any vector.
// fallback: what to return when v is zero, subnormal in every component, infinite or NaN.
// Returns a vector of length 1, or the fallback. Error: at most 5 ulp in each component.
vec3 gloam_safe_normalize(vec3 v, vec3 fallback) {
    if (!gloam_is_finite3(v)) return fallback;
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(largest >= GLOAM_SMALLEST)) return fallback;
    // Powers of two, so exact: 2^-80 for vectors longer than 2^32, 2^80 for those shorter than 2^-32.
    float scale = largest > 4294967296.0 ? 8.271806125530277e-25
                                         : (largest < 2.3283064365386963e-10 ? 1.2089258196146292e24 : 1.0);
    vec3 scaled = v * scale;
    return scaled * inversesqrt(dot(scaled, scaled));
}

#endif
