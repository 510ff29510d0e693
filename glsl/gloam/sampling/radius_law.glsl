// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_RADIUS_LAW_GLSL
#define GLOAM_SAMPLING_RADIUS_LAW_GLSL

#include "gloam/numeric/constants.glsl"
#include "gloam/numeric/square_root.glsl"
#include "gloam/sampling/unit_interval.glsl"

// Where the samples of a kernel lie along their directions decides the falloff that a plain average over them
// estimates: a sample at radius r blocks whatever hit lies nearer, so a hit at distance x of the kernel radius counts
// 1 - F(x), with F the distribution of r.

// sample radius for a falloff (RADIUS-linear): `r = zeta (falloff 1 - x)` [derived: falloff = 1 - distribution of the
// radius].
// Radius whose distribution is F(x) = x: the average has the linear falloff 1 - x (that of TSSAO-14).
// zeta: uniform number in [0, 1); taken to the nearer end outside, 0 for NaN.
// Returns zeta, the radius as a fraction of the kernel's. Error: none.
// No method or pass here calls it: it is there to be copied.
float gloam_radius_linear(float zeta) {
    return gloam_unit_interval(zeta);
}

// sample radius for a falloff (RADIUS-quadratic): `r = sqrt(zeta) (falloff 1 - x^2)` [derived: falloff = 1 -
// distribution of the radius].
// Radius whose distribution is F(x) = x^2 (uniform area of a disc): the average has the falloff 1 - x^2.
// zeta: uniform number in [0, 1); taken to the nearer end outside, 0 for NaN; a subnormal number is read as 0.
// Returns sqrt(zeta), the radius as a fraction of the kernel's. Error: at most 2 ulp.
// No method or pass here calls it: it is there to be copied.
float gloam_radius_quadratic(float zeta) {
    return gloam_sqrt(gloam_unit_interval(zeta));
}

// sample radius for a falloff (RADIUS-cubic): `r = zeta^(1/3) (falloff 1 - x^3)` [derived: falloff = 1 - distribution
// of the radius].
// Radius whose distribution is F(x) = x^3 (uniform volume of a ball): the average has the falloff 1 - x^3.
// zeta: uniform number in [0, 1); taken to the nearer end outside, 0 for NaN; a subnormal number is read as 0.
// Returns the cube root of zeta, the radius as a fraction of the kernel's. Error: at most 1.5 ulp; 5e-7 by any device
// that keeps Vulkan's rules for exp2() and log2().
// No method or pass here calls it: it is there to be copied.
float gloam_radius_cubic(float zeta) {
    float x = gloam_unit_interval(zeta);
    if (x < GLOAM_SMALLEST) return 0.0;
    // pow() alone may err by a hundred units in the last place; one step of Newton's method mends that.
    float root = exp2(log2(x) * 0.333333333);
    return root - (root - x / (root * root)) * 0.333333333;
}

#endif
