// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_ROTATION_GLSL
#define GLOAM_SAMPLING_ROTATION_GLSL

#include "gloam/numeric/sincos.glsl"

// Disc sample rotated about the centre (TSSAO-ROT).
// s: point of the unit disc (any vector of length below 1e19).
// angle: radians, counter-clockwise, |angle| <= 65536; anything else, NaN included, rotates by 0.
// Returns s rotated, of the same length; the zero vector for a longer, infinite or NaN s.
// Error: 4 ulp of the largest component, while that is above 1e-30; shorter vectors may be flushed to 0.
vec2 gloam_rotate_disc(vec2 s, float angle) {
    if (!(dot(s, s) <= 1e38)) return vec2(0.0);
    vec2 r = gloam_sincos(angle);
    return vec2(r.x * s.x - r.y * s.y, r.y * s.x + r.x * s.y);
}

// Hemisphere sample rotated about the normal (TSSAO-ROT).
// s: point of the unit half ball in tangent space, z along the normal (any vector of length below 1e19).
// angle: radians, counter-clockwise seen from the tip of the normal, |angle| <= 65536; anything else rotates by 0.
// Returns s rotated: same length, same angle to the normal; the zero vector for a longer, infinite or NaN s.
// Error: 4 ulp of the largest component, while that is above 1e-30; shorter vectors may be flushed to 0.
vec3 gloam_rotate_hemisphere(vec3 s, float angle) {
    if (!(dot(s, s) <= 1e38)) return vec3(0.0);
    return vec3(gloam_rotate_disc(s.xy, angle), s.z);
}

#endif
