// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_HEMISPHERE_GLSL
#define GLOAM_SAMPLING_HEMISPHERE_GLSL

#include "gloam/numeric/square_root.glsl"
#include "gloam/sampling/circle.glsl"

// point of the half ball: cosine-weighted direction, uniform radius (TSSAO-14): `a = 2 pi zeta_x, r = zeta_y; s = r
// (cos a sqrt(1 - zeta_z), sin a sqrt(1 - zeta_z), sqrt(zeta_z))` [TSSAO, eq 14 corrected; Ritschel's kernel].
// The Ritschel kernel, its misprint mended.
// zeta: uniform point of [0, 1)^3 (a Halton point); coordinates outside are taken to the nearer end, NaN to 0.
// Returns a point s in tangent space (z along the normal), |s| = zeta_y, s.z >= 0. Directions have density cos / pi,
// so an average over samples carries no further cosine. zeta_y = 0 gives the zero vector, which has no direction:
// skip it.
// Error: 3e-7.
vec3 gloam_hemisphere_cosine(vec3 zeta) {
    float radius = gloam_unit_interval(zeta.y);
    float cosine_squared = gloam_unit_interval(zeta.z);
    return radius * vec3(gloam_sqrt(1.0 - cosine_squared) * gloam_circle_point(zeta.x), gloam_sqrt(cosine_squared));
}

// point of the half ball: uniform direction, uniform radius (TSSAO-14-uniform): `a = 2 pi zeta_x, r = zeta_y; s = r
// (cos a sqrt(1 - zeta_z^2), sin a sqrt(1 - zeta_z^2), zeta_z)` [TSSAO, variant of eq 14].
// zeta: uniform point of [0, 1)^3 (a Halton point); coordinates outside are taken to the nearer end, NaN to 0.
// Returns a point s in tangent space (z along the normal), |s| = zeta_y, s.z >= 0. Directions have density 1 / (2
// pi), so an average over samples carries the cosine and a factor 2. zeta_y = 0 gives the zero vector: skip it.
// Error: 3e-7.
vec3 gloam_hemisphere_uniform(vec3 zeta) {
    float radius = gloam_unit_interval(zeta.y);
    float cosine = gloam_unit_interval(zeta.z);
    return radius * vec3(gloam_sqrt((1.0 - cosine) * (1.0 + cosine)) * gloam_circle_point(zeta.x), cosine);
}

#endif
