// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_CIRCLE_GLSL
#define GLOAM_SAMPLING_CIRCLE_GLSL

#include "gloam/sampling/unit_interval.glsl"

// Point of the unit circle a given part of a turn from the x axis: (cos 2 pi t, sin 2 pi t).
// turn: t in [0, 1], counter-clockwise; taken to the nearer end outside, 0 for NaN.
// Returns a vector of length 1. Error: 7e-7 beside that of the device's sin and cos, which Vulkan bounds by 2^-11 inside
// [-pi, pi] and not at all outside: hence the half turn taken off and the factor just below 2 pi.
vec2 gloam_circle_point(float turn) {
    float angle = (gloam_unit_interval(turn) - 0.5) * 6.283185005;
    return -vec2(cos(angle), sin(angle));
}

#endif
