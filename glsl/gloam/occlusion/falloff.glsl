// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_FALLOFF_GLSL
#define GLOAM_OCCLUSION_FALLOFF_GLSL

#include "gloam/numeric/constants.glsl"

// Weight of a hit by its distance (the D of TSSAO-1): 1 at the shaded point, 0 at the radius of influence. All
// functions use the magnitude of the distance and return 0 for NaN. With a radius that is zero, subnormal, negative or
// NaN no hit counts; with an infinite one every finite distance has the value at 0.
// The polynomials use 1 - d / R in the form (R - d) / R: subtracting before dividing keeps full relative accuracy up to
// the radius, where 1 - d / R loses it. The min() keeps a division or power that is rounded up inside [0, 1].

// linear falloff (FALLOFF-linear): `D = max(1 - d / R, 0)` [Aalund and Baerentzen 2013, reference images].
// What TSSAO's kernel of uniform radii implies, and the usual ray-traced reference.
// hit_distance: d, world units. radius: R, world units, > 0.
// Returns a weight in [0, 1]; 0 for R = 0. Error: 3 ULP.
float gloam_falloff_linear(float hit_distance, float radius) {
    float d = abs(hit_distance);
    if (!(d < radius && radius >= GLOAM_SMALLEST)) return 0.0;
    if (!(radius <= GLOAM_LARGEST)) return 1.0;
    // Powers of two, so exact: they keep the difference normal and the divisor where division is accurate.
    float scale =
        radius > 1.8446744e19 ? 5.421010862427522e-20 : (radius < 5.421010862427522e-20 ? 1.8446744073709552e19 : 1.0);
    float r = radius * scale;
    // In this order: 1 - d / r loses the digits of a small difference.
    GLOAM_PRECISE float left = (r - d * scale) / r;
    return min(left, 1.0);
}

// quadratic falloff (FALLOFF-quadratic): `D = max(1 - d^2 / R^2, 0)` [horizon-based AO, Bavoil and Sainz 2008].
// With a = 1 - d / R it is a (2 - a).
// hit_distance: d, world units. radius: R, world units, > 0.
// Returns a weight in [0, 1]; 0 for R = 0. Error: 4.5 ULP.
float gloam_falloff_quadratic(float hit_distance, float radius) {
    float a = gloam_falloff_linear(hit_distance, radius);
    return min(a * (2.0 - a), 1.0);
}

// step falloff (FALLOFF-step): `D = 1 if d <= R, else 0` [TSSAO, the simplest D of eq 1].
// The plain AO integral, cut off.
// hit_distance: d, world units. radius: R, world units, >= 0; at 0 only d = 0 counts.
// Returns 0 or 1. Error: none.
// No method or pass here calls it: it is TSSAO, the simplest D of eq 1; the methods draw radii instead.
float gloam_falloff_step(float hit_distance, float radius) {
    return abs(hit_distance) <= radius ? 1.0 : 0.0;
}

// exponential falloff, cut below 1/255 (FALLOFF-exponential): `D = exp(-d / R), 0 where below 1/255` [TSSAO,
// notes on eq 3].
// It would never end otherwise: the cut is at d = 5.5413 R.
// hit_distance: d, world units. radius: R, world units, > 0: the distance at which 1/e is left.
// Returns a weight in {0} and [1/255, 1]; 0 for R = 0. Error: 10 ULP; within 4 ULP of the cut a distance may fall to
// either side.
// No method or pass here calls it: it is TSSAO, the D = exp() of the notes on eq 3.
float gloam_falloff_exponential(float hit_distance, float radius) {
    float d = abs(hit_distance);
    if (!(d <= GLOAM_LARGEST && radius >= GLOAM_SMALLEST)) return 0.0;
    if (!(radius <= GLOAM_LARGEST)) return 1.0;
    float scale =
        radius > 1.8446744e19 ? 5.421010862427522e-20 : (radius < 5.421010862427522e-20 ? 1.8446744073709552e19 : 1.0);
    float r = radius * scale;
    float scaled = d * scale;
    return scaled <= 5.541263545 * r ? min(exp(-(scaled / r)), 1.0) : 0.0;
}

// falloff of Alchemy (FALLOFF-alchemy): `D = u d / max(u, d)^2` [McGuire et al. 2011; Aalund and Baerentzen 2013,
// eqs 3.6 to 3.10].
// That is u / d beyond u and d / u below: the obscurance of touching geometry vanishes.
// hit_distance: d, world units. u: distance of the strongest influence, world units, > 0.
// Returns a weight in [0, 1]; 0 (not 1) at d = 0, and 0 for u not positive, subnormal or NaN and for infinite d or u.
// Error: 2.5 ULP.
// No method or pass here calls it: it is the falloff of the comparative study; Alchemy's contribution has it.
float gloam_falloff_alchemy(float hit_distance, float u) {
    float d = abs(hit_distance);
    if (!(d <= GLOAM_LARGEST && u >= GLOAM_SMALLEST && u <= GLOAM_LARGEST)) return 0.0;
    float smaller = d < u ? d : u;
    float larger = d < u ? u : d;
    float scale =
        larger > 1.8446744e19 ? 5.421010862427522e-20 : (larger < 5.421010862427522e-20 ? 1.8446744073709552e19 : 1.0);
    return min(smaller * scale / (larger * scale), 1.0);
}

// A falloff selected by a setting, without the guards of falloff.glsl: for loops after gloam_can_gather. If the
// selection is constant, the compiler removes the other falloffs.
const uint GLOAM_FALLOFF_STEP = 0u;
const uint GLOAM_FALLOFF_LINEAR = 1u;
const uint GLOAM_FALLOFF_QUADRATIC = 2u;
const uint GLOAM_FALLOFF_CUBIC = 3u;

// falloff that a setting chooses, at a share of the radius (FALLOFF-choice): `step, 1 - x, 1 - x^2, 1 - x^3, not
// below 0` [definition].
// Weight of a hit at a share of the radius of influence (D of TSSAO-1). Another falloff is one more line.
// falloff: GLOAM_FALLOFF_*, linear for any other number. x: d / R, [0, 1e9].
// Returns D: 1 at x = 0, positive for x < 1, 0 from there on. Step: 1 up to x = 1, then 0. Linear: 1 - x. Quadratic:
// 1 - x^2. Cubic: 1 - x^3. Error: 2e-7.
float gloam_falloff_at(uint falloff, float x) {
    if (falloff == GLOAM_FALLOFF_STEP) return x <= 1.0 ? 1.0 : 0.0;
    if (falloff == GLOAM_FALLOFF_QUADRATIC) return max(1.0 - x * x, 0.0);
    if (falloff == GLOAM_FALLOFF_CUBIC) return max(1.0 - x * x * x, 0.0);
    return max(1.0 - x, 0.0);
}

#endif
