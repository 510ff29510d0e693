// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_HEMISPHERE_UNIFORM_POINT_GLSL
#define GLOAM_SAMPLING_HEMISPHERE_UNIFORM_POINT_GLSL

#include "gloam/sampling/halton.glsl"
#include "gloam/sampling/hemisphere.glsl"

// point of a sample: hemisphere_uniform (POINTS-hemisphere-uniform): `TSSAO-14-uniform of the Halton point` [TSSAO,
// eqs 13 and 14].
// Point of the half ball before it is rotated, uniform in direction and radius: what all pixels share of a sample
// (halton.glsl).
// index: number of the Halton point, 1 for the first. Returns the point in tangent space, z along the normal. Error:
// 2e-6 where the third coordinate of the Halton point is below 0.998; up to 5e-4 beyond, where the square root
// magnifies the error of that coordinate.
vec3 gloam_hemisphere_uniform_point(uint index) {
    return gloam_hemisphere_uniform(gloam_halton_3d(index));
}

#endif
