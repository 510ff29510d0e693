// SPDX-License-Identifier: MIT
#ifndef GLOAM_NUMERIC_LENGTH_RATIO_GLSL
#define GLOAM_NUMERIC_LENGTH_RATIO_GLSL

#include "gloam/numeric/constants.glsl"
#include "gloam/numeric/precise.glsl"

// the smaller over the larger of two lengths (RATIO): `a / b, 0 <= a <= b` [definition].
// At any scale.
// smaller, larger: 0 <= smaller <= larger; a subnormal larger length is read as the smallest normal number.
// Returns a ratio in [0, 1]; 0 for a finite over an infinite length, 1 for two infinite ones. Error: 2.5 ulp.
float gloam_length_ratio(float smaller, float larger) {
    if (larger > GLOAM_LARGEST) return smaller > GLOAM_LARGEST ? 1.0 : 0.0;
    // Vulkan says nothing of quotients by less than 2^-126 or more than 2^126.
    float scale = larger > GLOAM_LARGEST_DIVISOR ? 0.25 : 1.0;
    GLOAM_PRECISE float ratio = smaller * scale / (max(larger, GLOAM_SMALLEST) * scale);
    return min(ratio, 1.0);
}

#endif
