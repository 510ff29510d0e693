// SPDX-License-Identifier: MIT
#ifndef GLOAM_NUMERIC_SINCOS_GLSL
#define GLOAM_NUMERIC_SINCOS_GLSL

#include "gloam/numeric/constants.glsl"

// Cosine and sine made of products and sums. Vulkan lets those of the device err by 2^-11 inside [-pi, pi] and by
// anything outside; these are the same within 5e-7 on every conforming driver that does their operations in order
// (`precise`, NoContraction). A driver that reorders all that Vulkan lets it may err by 4e-6; none is known to. The
// coefficients are those of minimax polynomials; Sollya's fpminimax finds as good ones.

// cosine and sine of an angle near a multiple of a quarter turn (SINCOS-octant): `(cos a, sin a), a = r + q pi / 2`
// [minimax polynomials].
// rest: the angle less that multiple, radians, in [-pi / 4, pi / 4]; beyond, the polynomials part from the functions.
// quarters: the multiple, any integer; only its two lowest bits count.
// Returns (cos, sin) of rest + quarters pi / 2. Error: 4e-7 whatever the rounding, 1e-7 where it is to nearest; exact
// for rest = 0.
vec2 gloam_sincos_octant(float rest, int quarters) {
    float z = rest * rest;
    float c = (1.0 - 0.5 * z) + (z * z) * (0.0416666456 + z * (-0.00138873677 + z * 2.44384519e-05));
    float s = rest + (rest * z) * (-0.166666552 + z * (0.0083321603 + z * -0.000195152839));
    vec2 turned = (quarters & 1) != 0 ? vec2(-s, c) : vec2(c, s);
    return (quarters & 2) != 0 ? -turned : turned;
}

// cosine and sine of an angle in turns (SINCOS-turns): `(cos 2 pi t, sin 2 pi t)` [minimax polynomials after an exact
// reduction].
// turns: t, any finite number (from 2^23 on every float is a whole number of turns); infinity and NaN count as 0.
// Returns (cos, sin); exact at multiples of a quarter turn. Error: 5e-7 whatever the rounding, 2e-7 where it is to
// nearest.
vec2 gloam_sincos_turns(float turns) {
    float part = abs(turns) <= GLOAM_LARGEST ? turns - floor(turns + 0.5) : 0.0;
    float quarters = floor(4.0 * part + 0.5);
    // Exact up to the product: nothing is rounded when whole turns, and then quarters, are taken off.
    GLOAM_PRECISE float rest = part - 0.25 * quarters;
    return gloam_sincos_octant(rest * GLOAM_TAU, int(quarters));
}

// turns of an angle (TURNS): `a / (2 pi), 0 beyond 65536` [definition].
// angle: radians, |angle| <= 65536; anything else, NaN included, counts as 0.
// Returns turns. Error: 1.7 ULP whatever the rounding, 1.2 ULP where it is to nearest. It is one product, which every
// language rounds correctly; a quotient may err by 2.5 ULP more than the constant does.
float gloam_turns(float angle) {
    return abs(angle) <= 65536.0 ? angle * 0.159154943 : 0.0;
}

// cosine and sine of an angle in radians (SINCOS): `(cos a, sin a)` [Cody and Waite 1980; minimax polynomials].
// angle: |angle| <= 65536; anything else, NaN included, counts as 0.
// Returns (cos, sin). Error: 5e-7 whatever the rounding, 2e-7 where it is to nearest.
vec2 gloam_sincos(float angle) {
    float a = abs(angle) <= 65536.0 ? angle : 0.0;
    float quarters = floor(a * 0.636619772 + 0.5);
    // pi / 2 in three parts, the first two of eight bits: their products and the subtractions of them are exact.
    GLOAM_PRECISE float rest =
        ((a - quarters * 1.5703125) - quarters * 0.0004825592041015625) - quarters * 1.26759079506e-6;
    return gloam_sincos_octant(rest, int(quarters));
}

#endif
