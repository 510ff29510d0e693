// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_VISIBILITY_GLSL
#define GLOAM_OCCLUSION_VISIBILITY_GLSL

// visibility that stands for an amount of occlusion (VISIBILITY): `clamp(1 - x, 0, 1)` [definition].
// NaN counts as open.
// occlusion: x, any float.
// Returns visibility in [0, 1]; 1 for NaN. Error: 0.5 ULP.
// No method or pass here calls it: it is there to be copied.
float gloam_visibility(float occlusion) {
    return occlusion > 0.0 ? (occlusion < 1.0 ? 1.0 - occlusion : 0.0) : 1.0;
}

// visibility kept inside its range (VISIBILITY-clamp): `clamp(v, 0, 1)` [definition].
// visibility: any float.
// Returns visibility in [0, 1]: the nearer end outside; 1 for NaN. Error: none.
// No method or pass here calls it: it is there to be copied.
float gloam_visibility_clamp(float visibility) {
    return visibility < 1.0 ? (visibility > 0.0 ? visibility : 0.0) : 1.0;
}

#endif
