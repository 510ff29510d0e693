// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_FOX_COMPTON_GLSL
#define GLOAM_OCCLUSION_FOX_COMPTON_GLSL

#include "gloam/numeric/constants.glsl"

// Contribution of the surface patch seen at a tap, after Fox and Compton's crease shading: no visibility test, the
// patch itself is what blocks.

// contribution of a surface patch (TSSAO-12): `epsilon C = max(cos(s - p, n), 0) epsilon / max(epsilon, |s - p|)`
// [TSSAO (Mattausch et al.), eq 12 corrected; Fox and Compton 2008].
// The printed C is in 1 / length; times epsilon it is read as occlusion.
// offset: s - p, world units. normal: n, unit vector, same space. epsilon: world units, 0.01 to 0.1 of the kernel
// radius; a negative one counts as 0.
// Returns a contribution in [0, 1] where the patch is in front of the tangent plane: the cosine within epsilon of p,
// falling as epsilon / |s - p| beyond. Behind the plane it is negative: such a patch does not count. Error: 3.5e-7.
float gloam_contribution_fox_compton(vec3 offset, vec3 normal, float epsilon) {
    float inverse = inversesqrt(max(dot(offset, offset), GLOAM_LEAST_SQUARE));
    return min(dot(offset, normal) * inverse, 1.0) * min(max(epsilon, 0.0) * inverse, 1.0);
}

#endif
