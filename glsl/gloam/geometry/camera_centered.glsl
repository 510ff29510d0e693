// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_CAMERA_CENTERED_GLSL
#define GLOAM_GEOMETRY_CAMERA_CENTERED_GLSL

#include "gloam/geometry/finite.glsl"

// position relative to the previous eye (TSSAO-PREC): `q' = q + (eye - eye')` [TSSAO, precision of positions].
// Positions are stored relative to the eye because world coordinates far from the origin are coarse (at 1e5 a float's
// spacing is 0.008).
// position: q_f = x - eye_f, world axes and units. eye_delta: eye_f - eye_(f-1), subtracted in double by the host.
// Returns q_(f-1), world axes and units; the zero vector where it is not finite. Error: at most 1 ulp.
// No method or pass here calls it: it is TSSAO, the precision of positions, for engines without view-space positions.
vec3 gloam_camera_centered_previous(vec3 position, vec3 eye_delta) {
    vec3 previous = position + eye_delta;
    return gloam_is_finite3(previous) ? previous : vec3(0.0);
}

#endif
