// SPDX-License-Identifier: MIT
#ifndef GLOAM_NUMERIC_SQUARE_ROOT_GLSL
#define GLOAM_NUMERIC_SQUARE_ROOT_GLSL

#include "gloam/numeric/constants.glsl"

// square root that is 0 at 0 (SQRT): `x^(1/2), 0 for x <= 0` [x times its inverse square root].
// Vulkan derives sqrt() from 1 / inversesqrt(): 4.5 ulp, and undefined at 0.
// x: any float.
// Returns the square root; 0 for a number that is zero, subnormal, negative or NaN, infinity for infinity.
// Error: 7 ulp whatever the rounding, 2.5 ulp where it is to nearest.
float gloam_sqrt(float x) {
    return x >= GLOAM_SMALLEST ? (x <= GLOAM_LARGEST ? x * inversesqrt(x) : x) : 0.0;
}

#endif
