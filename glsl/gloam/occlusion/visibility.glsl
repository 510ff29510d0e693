// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_VISIBILITY_GLSL
#define GLOAM_OCCLUSION_VISIBILITY_GLSL

// Visibility for an amount of occlusion: 1 - x, clamped to [0, 1]. NaN counts as open.
// occlusion: x, any float.
// Returns visibility in [0, 1]; 1 for NaN. Error: 0.5 ULP.
// No method or pass here calls it: it is there to be copied.
float gloam_visibility(float occlusion) {
    return occlusion > 0.0 ? (occlusion < 1.0 ? 1.0 - occlusion : 0.0) : 1.0;
}

// Visibility kept inside [0, 1].
// visibility: any float.
// Returns visibility in [0, 1]: the nearer end outside; 1 for NaN. Error: none.
// No method or pass here calls it: it is there to be copied.
float gloam_visibility_clamp(float visibility) {
    return visibility < 1.0 ? (visibility > 0.0 ? visibility : 0.0) : 1.0;
}

#endif
