// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_BACKGROUND_GLSL
#define GLOAM_GEOMETRY_BACKGROUND_GLSL

#include "gloam/numeric/constants.glsl"

// depth of a pixel without geometry (BACKGROUND-depth): `+infinity` [convention].
// Returns +infinity. Error: none.
float gloam_background_depth() {
    return uintBitsToFloat(0x7F800000u);
}

// depth that stands for no geometry (BACKGROUND): `not (0 < d < infinity)` [convention].
// depth: eye-linear depth in world units, d = -z in view space.
// Returns false for a positive finite depth, true for zero, negative, infinite and NaN. A subnormal depth is read as
// 0, so that devices that flush subnormals agree with those that do not. Error: none.
bool gloam_is_background(float depth) {
    return !(depth >= GLOAM_SMALLEST && depth <= GLOAM_LARGEST);
}

#endif
