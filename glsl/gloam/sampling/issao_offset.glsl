// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_ISSAO_OFFSET_GLSL
#define GLOAM_SAMPLING_ISSAO_OFFSET_GLSL

#include "gloam/numeric/sincos.glsl"
#include "gloam/numeric/square_root.glsl"
#include "gloam/sampling/unit_interval.glsl"

// Sampling offsets of the improved method (ISSAO-1) in two readings. Radii are uniform, so taps are denser near the
// centre. The paper draws e_1 and e_2 "in a fixed relation" that it does not print; here they are independent.

// sampling offset inside the disc (ISSAO-1): `r_max e_1 (sin 2 pi e_2, cos 2 pi e_2)` [ISSAO, eq 1].
// The reading that fits the prose: r_max e_1 (sin 2 pi e_2, cos 2 pi e_2), inside the disc, its radius uniform.
// e: two numbers in [0, 1], taken to the nearer end outside, NaN to 0. radius: r_max, pixels or any unit, >= 0.
// Returns an offset in that unit, no longer than the radius but for rounding; (0, 0) for e_1 = 0. Error: 4e-7 of the
// radius.
vec2 gloam_issao_offset_polar(vec2 e, float radius) {
    vec2 p = gloam_sincos_turns(gloam_unit_interval(e.y));
    return radius * (gloam_unit_interval(e.x) * p.yx);
}

// sampling offset as printed, kept in the disc (ISSAO-1-printed): `r_max (e_1 sin 2 pi e_2, e_2 cos 2 pi e_1)` [ISSAO,
// eq 1].
// As printed: r_max (e_1 sin 2 pi e_2, e_2 cos 2 pi e_1). 3.1 % of these leave the disc, up to 1.26 r_max: they are
// moved to its border.
// e: two numbers in [0, 1], taken to the nearer end outside, NaN to 0. radius: r_max, pixels or any unit, >= 0.
// Returns an offset in that unit, no longer than the radius but for rounding. Error: 6e-7 of the radius.
// No method or pass here calls it: it is ISSAO, eq 1, as printed; the methods take the other reading.
vec2 gloam_issao_offset_printed(vec2 e, float radius) {
    vec2 u = vec2(gloam_unit_interval(e.x), gloam_unit_interval(e.y));
    vec2 offset = u * vec2(gloam_sincos_turns(u.y).y, gloam_sincos_turns(u.x).x);
    float squared = dot(offset, offset);
    return radius * (squared > 1.0 ? offset / gloam_sqrt(squared) : offset);
}

#endif
