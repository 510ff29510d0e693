// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_VECTOR_GLSL
#define GLOAM_GEOMETRY_VECTOR_GLSL

#include "gloam/geometry/background.glsl"

// unit vector along any vector that has a direction (NORMALIZE): `v / |v|; the fallback where v is zero, infinite or
// NaN` [definition].
// normalize() overflows above 1e19 and underflows below 1e-19.
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

// length of a vector of any size (LENGTH-vector): `|v| = v . (v / |v|)` [definition].
// length() overflows above 1e19 and underflows below 1e-19.
// v: any vector.
// Returns a length >= 0, in the unit of v; 0 for a vector that is zero, subnormal, infinite or NaN. Error: 4 ulp for
// lengths from 1e-30 to 1e38.
float gloam_length(vec3 v) {
    float along = dot(v, gloam_safe_normalize(v, vec3(0.0)));  // NaN for an infinite v, which max() may return or not
    return along > 0.0 ? along : 0.0;
}

// height of the surface of a tap at the aimed place (PAIR-height): `((s - p - a) . n) / (v . n)` [definition].
// How far along the view vector from an aimed place the surface lies that is as high over the tangent plane as what
// was seen.
// offset: s - p, from the shaded point to what was seen. aim: a, from there to the place, in the plane of the image;
// world units. normal: n, unit. facing: v . n, v the view vector, at least 1e-4.
// Returns a length in world units. Error: 1.5e-7 of the offset over v . n.
float gloam_height_at(vec3 offset, vec3 aim, vec3 normal, float facing) {
    return dot(offset - aim, normal) / facing;
}

#endif
