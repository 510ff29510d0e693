// SPDX-License-Identifier: MIT
#ifndef GLOAM_NUMERIC_CONSTANTS_GLSL
#define GLOAM_NUMERIC_CONSTANTS_GLSL

const float GLOAM_PI = 3.141592654;
const float GLOAM_TAU = 6.283185307;  // 2 pi, a whole turn in radians

#endif
