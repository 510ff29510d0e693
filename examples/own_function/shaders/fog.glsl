// SPDX-License-Identifier: MIT
#ifndef FOG_GLSL
#define FOG_GLSL

#include "gloam/geometry/background.glsl"

float fog_weight(float depth) {
    return gloam_is_background(depth) ? 1.0 : 1.0 - exp2(-depth);
}

#endif
