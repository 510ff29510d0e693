// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_FALLOFF_GLSL
#define GLOAM_OCCLUSION_FALLOFF_GLSL

#include "gloam/numeric/constants.glsl"
#include "gloam/numeric/precise.glsl"

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

#endif
