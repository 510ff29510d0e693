// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_ROTATION_GLSL
#define GLOAM_SAMPLING_ROTATION_GLSL

#include "gloam/numeric/sincos.glsl"

// What rotates many samples by one angle turns them by its cosine and sine, computed once: not every driver moves
// them out of a loop.

// disc sample turned by the cosine and sine of an angle (TSSAO-ROT-turn-disc): `(c x - s y, s x + c y)` [TSSAO,
// random rotation].
// s: point of the unit disc (any vector of length below 1e19). turn: (cos, sin) of the angle, as gloam_sincos gives it.
// Returns s rotated counter-clockwise, of the same length; infinite or NaN for a longer, infinite or NaN s.
// Error: 3 ulp of the largest component, while that is above 1e-30; shorter vectors may be flushed to 0.
vec2 gloam_turn_disc(vec2 s, vec2 turn) {
    return vec2(turn.x * s.x - turn.y * s.y, turn.y * s.x + turn.x * s.y);
}

// hemisphere sample turned by the cosine and sine of an angle (TSSAO-ROT-turn-hemisphere): `(c x - s y, s x + c y, z)`
// [TSSAO, random rotation].
// s: point of the unit half ball in tangent space, z along the normal (any vector of length below 1e19). turn: as
// above.
// Returns s rotated counter-clockwise seen from the tip of the normal: same length, same angle to the normal; infinite
// or NaN for a longer, infinite or NaN s. Error: 3 ulp of the largest component, while that is above 1e-30; shorter
// vectors may be flushed to 0.
vec3 gloam_turn_hemisphere(vec3 s, vec2 turn) {
    return vec3(gloam_turn_disc(s.xy, turn), s.z);
}

// disc sample rotated about the centre (TSSAO-ROT-disc): `(c x - s y, s x + c y)` [TSSAO, random rotation].
// s: as for gloam_turn_disc.
// angle: radians, counter-clockwise, |angle| <= 65536; anything else, NaN included, rotates by 0.
// Returns s rotated, of the same length; infinite or NaN for a longer, infinite or NaN s.
// Error: 4 ulp of the largest component, while that is above 1e-30; shorter vectors may be flushed to 0.
vec2 gloam_rotate_disc(vec2 s, float angle) {
    return gloam_turn_disc(s, gloam_sincos(angle));
}

// hemisphere sample rotated about the normal (TSSAO-ROT-hemisphere): `(c x - s y, s x + c y, z)` [TSSAO,
// random rotation].
// s: as for gloam_turn_hemisphere.
// angle: radians, counter-clockwise seen from the tip of the normal, |angle| <= 65536; anything else rotates by 0.
// Returns s rotated: same length, same angle to the normal; infinite or NaN for a longer, infinite or NaN s.
// Error: 4 ulp of the largest component, while that is above 1e-30; shorter vectors may be flushed to 0.
vec3 gloam_rotate_hemisphere(vec3 s, float angle) {
    return gloam_turn_hemisphere(s, gloam_sincos(angle));
}

#endif
