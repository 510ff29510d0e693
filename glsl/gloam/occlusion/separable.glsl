// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_SEPARABLE_GLSL
#define GLOAM_OCCLUSION_SEPARABLE_GLSL

#include "gloam/filter/weights.glsl"

// Separable ambient occlusion (Huang et al. 2011): along one direction of a pair first, then along the other; the
// pair is turned at random from pixel to pixel and a blur hides it. What stands only on the diagonals is missed.

// occlusion of two directions (CS-O): `(AO_u + AO_v) / 2` [Huang et al. 2011 (separable AO), reconstructed].
// The simple form: the mean of the two one-dimensional estimates.
// along_u, along_v: occlusion, [0, 1]; outside, the nearer end; 0 for NaN.
// Returns occlusion in [0, 1]; the same when the directions are exchanged. Error: 0.5 ULP.
float gloam_separable_mean(float along_u, float along_v) {
    return 0.5 * (gloam_unit_interval(along_u) + gloam_unit_interval(along_v));
}

// weight of a neighbour whose first-pass occlusion is taken over (CS-O-weight): `exp(-|q - p|^2 / (2 sigma^2)) if |(q -
// p) . n| <= tolerance, else 0` [Huang et al. 2011 (separable AO), reconstructed].
// The transport form, for gloam_weighted_mean_add.
// offset: q - p, world units. normal: n of p, unit vector, same space. sigma: world units, see gloam_gaussian.
// tolerance: world units.
// Returns a weight in [0, 1]; 1 for q = p, 0 for what is not finite. Error: 5e-7, but for points within rounding of
// the tolerance.
float gloam_separable_weight(vec3 offset, vec3 normal, float sigma, float tolerance) {
    bool on_plane = abs(dot(offset, normal)) <= tolerance;
    return on_plane ? gloam_gaussian(dot(offset, offset), sigma) : 0.0;
}

#endif
