// SPDX-License-Identifier: MIT
#ifndef GLOAM_NUMERIC_CONSTANTS_GLSL
#define GLOAM_NUMERIC_CONSTANTS_GLSL

const float GLOAM_PI = 3.141592654;
const float GLOAM_HALF_PI = 1.570796327;
const float GLOAM_TAU = 6.283185307;  // 2 pi, a whole turn in radians

// Limits that values are tested against.
const float GLOAM_LARGEST = 3.402823466e38;          // the largest finite float
const float GLOAM_LARGEST_DIVISOR = 8.507059173e37;  // 2^126: above it, Vulkan bounds no division's error
const float GLOAM_LEAST_SQUARE = 1e-36;              // of a length: inverse roots and their products stay finite

// 2^-126, the smallest normal float; a device may read less as 0. By divisions, which are exact: Firefox 153 reads the
// literal 1.175494351e-38 as 0.
const float GLOAM_SMALLEST = 0.25 / 2147483648.0 / 2147483648.0 / 2147483648.0 / 2147483648.0;

// Keeps the order of operations where a language has the word. Vulkan else lets a driver add up what an expression
// subtracts one after the other, which undoes a reduction of an argument.
#if (defined(GL_ES) && __VERSION__ >= 320) || (!defined(GL_ES) && __VERSION__ >= 400)
#define GLOAM_PRECISE precise
#else
#define GLOAM_PRECISE
#endif

#endif
