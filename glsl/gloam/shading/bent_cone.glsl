// SPDX-License-Identifier: MIT
#ifndef GLOAM_SHADING_BENT_CONE_GLSL
#define GLOAM_SHADING_BENT_CONE_GLSL

#include "gloam/numeric/constants.glsl"
#include "gloam/numeric/inverse_trigonometry.glsl"
#include "gloam/numeric/square_root.glsl"
#include "gloam/sampling/unit_interval.glsl"

// Half angle of the cone around the bent normal that stands for the open directions.

// half angle of the open cone, as published (CS-L-cone-linear): `(1 - max(0, 2 L - 1)) pi / 2` [Klehm et al. 2011].
// From the length of the mean direction.
// agreement: L of gloam_bent_length, [0, 1]; outside, the nearer end; 0 for NaN.
// Returns radians in [0, pi / 2]. Right for an open hemisphere and for a point, 15 degrees too small for a cap of 60.
// Error: 2e-7.
// No method or pass here calls it: it is there to be copied.
float gloam_cone_angle_linear(float agreement) {
    return (1.0 - max(2.0 * gloam_unit_interval(agreement) - 1.0, 0.0)) * GLOAM_HALF_PI;
}

// half angle of the open cone, exact for a cap (CS-L-cone): `arccos(max(0, 2 L - 1))` [derived: L = (1 + cos a) / 2].
// From the length of the mean direction; exact for directions uniform in a cap, L = (1 + cos a) / 2.
// agreement: L of gloam_bent_length, [0, 1]; outside, the nearer end; 0 for NaN.
// Returns radians in [0, pi / 2]: an L below 1/2 is not that of a cap, and gives pi / 2. Error: 4e-7.
float gloam_cone_angle(float agreement) {
    return gloam_acos(max(2.0 * gloam_unit_interval(agreement) - 1.0, 0.0));
}

// half angle from visibility, uniform measure (CS-L-cone-uniform): `arccos(1 - v)` [derived: v = 1 - cos a].
// Half angle from visibility alone, uniform measure (each solid angle counts the same): arccos(1 - v), which is 2
// arcsin(sqrt(v / 2)).
// visibility: v in [0, 1], 1 open; outside, the nearer end; 0 for NaN.
// Returns radians in [0, pi / 2]. Error: 6e-7.
// No method or pass here calls it: it is there to be copied.
float gloam_cone_angle_uniform(float visibility) {
    return 2.0 * gloam_asin(gloam_sqrt(0.5 * gloam_unit_interval(visibility)));
}

// half angle from visibility, cosine measure (CS-L-cone-cosine): `arcsin(sqrt(v))` [derived: v = sin^2 a].
// From visibility alone, for a cone around the normal: sin^2 a = v, the measure of ambient occlusion.
// visibility: v in [0, 1], 1 open; outside, the nearer end; 0 for NaN.
// Returns radians in [0, pi / 2]. Error: 4e-7.
// No method or pass here calls it: it is there to be copied.
float gloam_cone_angle_cosine(float visibility) {
    float v = gloam_unit_interval(visibility);
    // From the nearer end, where the square root loses nothing.
    return v > 0.5 ? GLOAM_HALF_PI - gloam_asin(gloam_sqrt(1.0 - v)) : gloam_asin(gloam_sqrt(v));
}

#endif
