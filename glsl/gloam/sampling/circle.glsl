// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_CIRCLE_GLSL
#define GLOAM_SAMPLING_CIRCLE_GLSL

#include "gloam/numeric/sincos.glsl"
#include "gloam/sampling/unit_interval.glsl"

// Point of the unit circle a given part of a turn from the x axis: (cos 2 pi t, sin 2 pi t).
// turn: t in [0, 1], counter-clockwise; taken to the nearer end outside, 0 for NaN.
// Returns a vector of length 1. Error: 2e-7.
vec2 gloam_circle_point(float turn) {
    return gloam_sincos_turns(gloam_unit_interval(turn));
}

#endif
