// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_CIRCLE_GLSL
#define GLOAM_SAMPLING_CIRCLE_GLSL

#include "gloam/numeric/sincos.glsl"
#include "gloam/sampling/unit_interval.glsl"

// point of the unit circle at a part of a turn (CIRCLE): `(cos 2 pi t, sin 2 pi t)` [definition].
// turn: t in [0, 1], counter-clockwise; taken to the nearer end outside, 0 for NaN.
// Returns a vector of length 1. Error: 2e-7.
vec2 gloam_circle_point(float turn) {
    return gloam_sincos_turns(gloam_unit_interval(turn));
}

#endif
