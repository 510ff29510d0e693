// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_DISC_GLSL
#define GLOAM_SAMPLING_DISC_GLSL

#include "gloam/numeric/arithmetic.glsl"
#include "gloam/numeric/sincos.glsl"
#include "gloam/sampling/halton.glsl"
#include "gloam/sampling/unit_interval.glsl"

// point of the unit circle at a part of a turn (CIRCLE): `(cos 2 pi t, sin 2 pi t)` [definition].
// turn: t in [0, 1], counter-clockwise; taken to the nearer end outside, 0 for NaN.
// Returns a vector of length 1. Error: 2e-7.
vec2 gloam_circle_point(float turn) {
    return gloam_sincos_turns(gloam_unit_interval(turn));
}

// uniform point of the disc (TSSAO-13): `a = 2 pi zeta_x, r = sqrt(zeta_y); s = (r cos a, r sin a)` [TSSAO,
// eq 13; Fox and Compton's kernel].
// zeta: uniform point of [0, 1)^2 (a Halton point). Outside, zeta_x counts modulo 1 and zeta_y is taken to the nearer
// end; NaN counts as 0, an infinite zeta_x too.
// Returns a point of the unit disc of density 1 / pi; scale it by the projected radius. zeta_y = 0 gives the centre.
// Error: 3e-7.
vec2 gloam_disc_sample(vec2 zeta) {
    return min(gloam_sqrt(zeta.y), 1.0) * gloam_sincos_turns(zeta.x);
}

// point of a sample: disc (POINTS-disc): `TSSAO-13 of the Halton point` [TSSAO, eqs 13 and 14].
// Before it is rotated: what all pixels share of a tap.
// index: number of the Halton point, 1 for the first. Returns the point in xy; z is 0. Error: 5e-7.
vec3 gloam_disc_point(uint index) {
    return vec3(gloam_disc_sample(gloam_halton_2d(index)), 0.0);
}

// point of a spiral (SPIRAL-point): `a = (i + 1/2) / n; a (cos(2 pi a turns), sin(2 pi a turns))` [McGuire, Mara and
// Luebke 2012 (Scalable Ambient Obscurance)].
// index: number of the tap, 0 to count - 1.
// count: number of taps, 1 to 32768.
// turns: turns of the spiral (7 for 9 taps; best coprime with count); negative turns run clockwise.
// Returns an offset in the unit disc: radii uniform, so the taps grow dense towards the centre. The zero vector for a
// count or an index outside its range. Error: 5e-7.
vec2 gloam_spiral_point(int index, int count, int turns) {
    if (count < 1 || count > 32768 || index < 0 || index >= count) return vec2(0.0);
    uint period = 2u * uint(count);
    uint odd = 2u * uint(index) + 1u;
    // The angle in units of 1 / period of a turn, its whole turns taken off in integers.
    uint angle = ((uint(abs(turns)) % period) * odd) % period;
    vec2 tap = gloam_circle_point(float(angle) / float(period));
    float radius = float(odd) / float(period);
    return radius * vec2(tap.x, turns < 0 ? -tap.y : tap.y);
}

// Sampling offsets of the improved method (ISSAO-1) in two readings. Radii are uniform, so taps are denser near the
// centre. The paper draws e_1 and e_2 "in a fixed relation" that it does not print; here they are independent.

// sampling offset inside the disc (ISSAO-1): `r_max e_1 (sin 2 pi e_2, cos 2 pi e_2)` [ISSAO, eq 1].
// The reading that fits the prose; its radius is uniform.
// e: two numbers in [0, 1], taken to the nearer end outside, NaN to 0. radius: r_max, pixels or any unit, >= 0.
// Returns an offset in that unit, no longer than the radius but for rounding; (0, 0) for e_1 = 0. Error: 4e-7 of the
// radius.
vec2 gloam_issao_offset_polar(vec2 e, float radius) {
    vec2 p = gloam_sincos_turns(gloam_unit_interval(e.y));
    return radius * (gloam_unit_interval(e.x) * p.yx);
}

// sampling offset as printed, kept in the disc (ISSAO-1-printed): `r_max (e_1 sin 2 pi e_2, e_2 cos 2 pi e_1)` [ISSAO,
// eq 1].
// 3.1 % of the printed offsets leave the disc, up to 1.26 r_max. Here these are moved to its border, because the prose
// samples the inside of the circle alone.
// e: two numbers in [0, 1], taken to the nearer end outside, NaN to 0. radius: r_max, pixels or any unit, >= 0.
// Returns an offset in that unit, no longer than the radius but for rounding. Error: 6e-7 of the radius.
// No method or pass here calls it: it is ISSAO, eq 1, as printed; the methods take the other reading.
vec2 gloam_issao_offset_printed(vec2 e, float radius) {
    vec2 u = vec2(gloam_unit_interval(e.x), gloam_unit_interval(e.y));
    vec2 offset = u * vec2(gloam_sincos_turns(u.y).y, gloam_sincos_turns(u.x).x);
    float squared = dot(offset, offset);
    return radius * (squared > 1.0 ? offset / gloam_sqrt(squared) : offset);
}

// point of a Poisson disc of 64 (POISSON-disc): `radius sqrt((i' + 1/2) / 64), i' the index with its bits reversed, at
// the emptiest of 4096 angles` [Sourimant et al. 2011 (the pattern); construction after Mitchell's best candidates].
// Each prefix is spread evenly: a point is at that angle (the first at 0) where the nearest of those before it is
// farthest away. For Sourimant's directions lift them with gloam_hemisphere_lift.
// index: of the point; its lowest 6 bits count.
// Returns a point of the unit disc. No two are nearer than 0.15 to each other; 0.3 among the first 16. Error: none.
vec2 gloam_poisson_disc(uint index) {
    const vec2 points[64] = vec2[64](
        vec2(0.0883883461, 0), vec2(-0.712609649, 0), vec2(-0.311770916, 0.400763512),
        vec2(-0.312051117, -0.812672496), vec2(-0.312009633, -0.188314885), vec2(0.385711133, 0.695729434),
        vec2(0.229740798, -0.574483812), vec2(0.934622943, -0.0963971317), vec2(-0.242908403, 0.106339112),
        vec2(0.685140431, 0.317639917), vec2(0.514554143, -0.235683128), vec2(-0.1108687, 0.898899674),
        vec2(0.0855535492, 0.43358171), vec2(-0.667464852, -0.499803156), vec2(-0.601041734, 0.289933354),
        vec2(0.6969257, -0.677943289), vec2(-0.0688622892, -0.185257882), vec2(-0.0236474145, -0.733827829),
        vec2(-0.222390711, -0.489494503), vec2(-0.470620275, 0.753378451), vec2(0.341203958, 0.218271315),
        vec2(0.139316902, 0.802903056), vec2(0.64288342, 0.0276297759), vec2(0.269099116, -0.917413831),
        vec2(0.196452528, -0.250936061), vec2(-0.733029485, -0.253436923), vec2(-0.126358882, 0.579306424),
        vec2(0.834202647, -0.394548446), vec2(-0.474413574, 0.0386554971), vec2(-0.64883852, 0.552784801),
        vec2(0.480595469, -0.495570868), vec2(-0.953617692, 0.25918296), vec2(-0.0475763083, 0.145512864),
        vec2(0.524750054, 0.498071194), vec2(0.0200485289, -0.522528052), vec2(0.867411554, 0.14503333),
        vec2(0.384438038, -0.0253948253), vec2(-0.480682135, -0.646051228), vec2(-0.462465346, -0.429608315),
        vec2(-0.941593349, -0.108809456), vec2(0.150709718, 0.251443982), vec2(0.739887059, -0.19622609),
        vec2(0.306320369, 0.492042005), vec2(0.473646104, -0.782046556), vec2(-0.400650501, 0.224536568),
        vec2(-0.277958483, 0.796038032), vec2(-0.322794497, 0.597278178), vec2(0.793588459, 0.575460553),
        vec2(-0.227852762, -0.0526366793), vec2(0.638225377, -0.383869559), vec2(-0.525177896, -0.169928402),
        vec2(-0.800641656, 0.404549688), vec2(-0.13420254, 0.402090997), vec2(-0.810503244, 0.150903866),
        vec2(-0.49039638, 0.434969962), vec2(-0.11656066, -0.957131684), vec2(0.0366879702, -0.340354949),
        vec2(0.157990381, -0.769562542), vec2(0.047357738, 0.604106545), vec2(0.609334469, 0.704200983),
        vec2(0.359528571, -0.336045712), vec2(0.680785716, -0.52793777), vec2(-0.19539848, -0.673800349),
        vec2(0.342754632, 0.935257614));
    return points[index & 63u];
}

#endif
