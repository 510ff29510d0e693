// SPDX-License-Identifier: MIT
#ifndef GLOAM_SHADING_BENT_CONE_GLSL
#define GLOAM_SHADING_BENT_CONE_GLSL

#include "gloam/numeric/inverse_trigonometry.glsl"
#include "gloam/sampling/unit_interval.glsl"

// Half angle of the cone around the bent normal that stands for the open directions.

// half angle of the open cone, exact for a cap (CS-L-cone): `arccos(max(0, 2 L - 1))` [derived: L = (1 + cos a) / 2].
// agreement: L of gloam_bent_length, [0, 1]; outside, the nearer end; 0 for NaN.
// Returns radians in [0, pi / 2]: an L below 1/2 is not that of a cap, and gives pi / 2. Error: 4e-7.
float gloam_cone_angle(float agreement) {
    return gloam_acos(max(2.0 * gloam_unit_interval(agreement) - 1.0, 0.0));
}

#endif
