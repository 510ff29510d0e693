// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_FOX_COMPTON_GLSL
#define GLOAM_OCCLUSION_FOX_COMPTON_GLSL

#include "gloam/numeric/constants.glsl"

// Contribution of the surface patch seen at a tap, after Fox and Compton's crease shading: no visibility test, the
// patch itself is what blocks.

// contribution of a surface patch (TSSAO-12): `epsilon C = max(cos(s - p, n), 0) epsilon / max(epsilon, |s - p|)`
// [TSSAO, eq 12 corrected; Fox and Compton 2008].
// The printed C is in 1 / length (gloam_contribution_fox_compton_unscaled); times epsilon it is read as occlusion.
// offset: s - p, world units. normal: n, unit vector, same space. epsilon: world units, 0.01 to 0.1 of the kernel
// radius; a negative one counts as 0.
// Returns a contribution in [0, 1]: the cosine within epsilon of p, falling as epsilon / |s - p| beyond; 0 for s = p
// and for a patch in or behind the tangent plane. Error: 3.5e-7.
float gloam_contribution_fox_compton(vec3 offset, vec3 normal, float epsilon) {
    float inverse = inversesqrt(max(dot(offset, offset), GLOAM_LEAST_SQUARE));
    return clamp(dot(offset, normal) * inverse, 0.0, 1.0) * min(max(epsilon, 0.0) * inverse, 1.0);
}

// contribution of a surface patch, in 1 / length (TSSAO-12-unscaled): `C = max(cos(s - p, n), 0) / max(epsilon, |s -
// p|)` [TSSAO, eq 12 corrected; Fox and Compton 2008].
// A length has to multiply its mean before that is occlusion.
// offset: s - p, world units. normal: n, unit vector, same space. epsilon: world units, > 0.
// Returns a contribution in 1 / world units, in [0, 1 / epsilon]; 0 for s = p and for a patch in or behind the tangent
// plane. Error: 4e-7 over the larger of epsilon and |s - p|.
// No method or pass here calls it: it is TSSAO, eq 12, as printed; the method takes it times epsilon.
float gloam_contribution_fox_compton_unscaled(vec3 offset, vec3 normal, float epsilon) {
    float squared = dot(offset, offset);
    float inverse = inversesqrt(max(squared, GLOAM_LEAST_SQUARE));
    return clamp(dot(offset, normal) * inverse, 0.0, 1.0) / max(epsilon, squared * inverse);
}

#endif
