// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_FOX_COMPTON_GLSL
#define GLOAM_OCCLUSION_FOX_COMPTON_GLSL

#include "gloam/numeric/constants.glsl"
#include "gloam/numeric/length_ratio.glsl"
#include "gloam/occlusion/cosine.glsl"

// Contribution of the surface patch seen at a tap, after Fox and Compton's crease shading: no visibility test, the
// patch itself is what blocks.

// contribution of a surface patch, in 1 / length (TSSAO-12): `C = max(cos(s - p, n), 0) / max(epsilon, |s - p|)` [TSSAO
// (Mattausch et al.), eq 12 corrected; Fox and Compton 2008].
// position: p, sample_position: s, world units, same space. normal: n, unit vector. epsilon: world units, > 0, 0.01
// to 0.1 of the kernel radius.
// Returns a contribution in 1 / world units, at most 1 / epsilon: multiply by a length before it is read as
// occlusion. 0 for s = p, for epsilon infinite or NaN, and where s - p is not finite. An epsilon of 0 or less bounds
// nothing. The larger of epsilon and |s - p| is taken into [2^-126, 2^126], where division is accurate.
// Error: 3e-6 for an epsilon of 0.03 or more, 1e-7 / epsilon below.
// No method or pass here calls it: it is there to be copied.
float gloam_contribution_fox_compton(vec3 position, vec3 normal, vec3 sample_position, float epsilon) {
    vec3 offset = sample_position - position;
    float cosine = gloam_sample_cosine(offset, normal);
    if (!(cosine > 0.0 && epsilon <= GLOAM_LARGEST)) return 0.0;
    // |s - p| as a dot product with its own direction: its square would overflow above 1e19.
    float reach = dot(offset, gloam_safe_normalize(offset, vec3(0.0)));
    return cosine / clamp(reach > epsilon ? reach : epsilon, GLOAM_SMALLEST, GLOAM_LARGEST_DIVISOR);
}

// contribution of a surface patch (TSSAO-12-scaled): `epsilon C = max(cos(s - p, n), 0) epsilon / max(epsilon, |s -
// p|)` [TSSAO (Mattausch et al.), eq 12 corrected; Fox and Compton 2008].
// position: p, sample_position: s, world units, same space. normal: n, unit vector. epsilon: world units, >= 0.
// Returns a contribution in [0, 1]: the cosine within epsilon of p, falling as epsilon / |s - p| beyond. 0 for s = p,
// epsilon <= 0 or NaN, and where s - p is not finite; the cosine for an infinite epsilon. Error: 3e-7, unless a
// component of s - p is subnormal: a device may flush it to 0.
// No method or pass here calls it: it is there to be copied.
float gloam_contribution_fox_compton_scaled(vec3 position, vec3 normal, vec3 sample_position, float epsilon) {
    vec3 offset = sample_position - position;
    float cosine = gloam_sample_cosine(offset, normal);
    if (!(cosine > 0.0 && epsilon > 0.0)) return 0.0;
    float reach = dot(offset, gloam_safe_normalize(offset, vec3(0.0)));
    return reach > epsilon ? cosine * gloam_length_ratio(epsilon, reach) : cosine;
}

#endif
