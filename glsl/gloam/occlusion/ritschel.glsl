// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_RITSCHEL_GLSL
#define GLOAM_OCCLUSION_RITSCHEL_GLSL

#include "gloam/sampling/unit_interval.glsl"

// contribution of a sample point, as printed (TSSAO-3): `C = V D max(cos, 0)` [TSSAO, eq 3; Ritschel et al. 2009].
// Averaged over uniform directions it gives half the occlusion, over cosine-weighted ones two thirds of it where
// everything is blocked: the mean of the occlusion (TSSAO-1) is that of V D for cosine-weighted directions (TSSAO-14),
// and of 2 V D cos for uniform ones. Every argument is clamped to [0, 1], and NaN is read as 0.
// blocked: V, 1 blocked, 0 open. falloff: D in [0, 1] (1 for a kernel of uniform radii). cosine: of the angle to the
// normal.
// Returns a contribution in [0, 1]. Error: 1.5 ULP.
// No method or pass here calls it: it is TSSAO, eq 3, as printed; the methods draw directions by the cosine.
float gloam_contribution_ritschel(float blocked, float falloff, float cosine) {
    return gloam_unit_interval(blocked) * gloam_unit_interval(falloff) * gloam_unit_interval(cosine);
}

// contribution of a sample point, uniform directions (TSSAO-3-uniform): `C = 2 V D max(cos, 0)` [TSSAO,
// eq 3 normalised for density 1 / (2 pi)].
// Directions have the density 1 / (2 pi).
// blocked: V, 1 blocked, 0 open. falloff: D in [0, 1] (1 for a kernel of uniform radii). cosine: of the angle to the
// normal.
// Returns a contribution in [0, 2] whose mean is the occlusion: clamp the mean, not the contribution. Error: 1.5 ULP.
// No method or pass here calls it: it is TSSAO, eq 3, for uniform directions; the methods draw by the cosine.
float gloam_contribution_uniform_directions(float blocked, float falloff, float cosine) {
    // 2 V: a factor 2 of the product would be moved behind it by Mesa's OpenGL, and the smaller product flushed to 0.
    float twice = blocked > 0.0 ? (blocked < 1.0 ? 2.0 * blocked : 2.0) : 0.0;
    return twice * gloam_unit_interval(falloff) * gloam_unit_interval(cosine);
}

#endif
