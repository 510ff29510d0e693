// SPDX-License-Identifier: MIT
#ifndef GLOAM_SHADING_AMBIENT_LIGHT_GLSL
#define GLOAM_SHADING_AMBIENT_LIGHT_GLSL

#include "gloam/sampling/unit_interval.glsl"

// ambient light that arrives (ISSAO-2): `I_a = I_0 (1 - A_0)` [ISSAO, eq 2, reconstructed].
// incident: I_0, any unit. occlusion: A_0 in [0, 1], taken to the nearer end outside, NaN to 0.
// Returns light in the unit of I_0. Error: 1.5 ULP.
vec3 gloam_ambient_light(vec3 incident, float occlusion) {
    return incident * (1.0 - gloam_unit_interval(occlusion));
}

#endif
