// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_FALLOFF_CHOICE_GLSL
#define GLOAM_OCCLUSION_FALLOFF_CHOICE_GLSL

// A falloff selected by a setting, without the guards of falloff.glsl: for loops after gloam_can_gather. If the
// selection is constant, the compiler removes the other falloffs.
const uint GLOAM_FALLOFF_STEP = 0u;
const uint GLOAM_FALLOFF_LINEAR = 1u;
const uint GLOAM_FALLOFF_QUADRATIC = 2u;
const uint GLOAM_FALLOFF_CUBIC = 3u;

// falloff that a setting chooses, at a share of the radius (FALLOFF-choice): `step, 1 - x, 1 - x^2, 1 - x^3, not
// below 0` [definition].
// Weight of a hit at a share of the radius of influence (D of TSSAO-1). Another falloff is one more line.
// falloff: GLOAM_FALLOFF_*, linear for any other number. x: d / R, [0, 1e9].
// Returns D: 1 at x = 0, positive for x < 1, 0 from there on. Step: 1 up to x = 1, then 0. Linear: 1 - x. Quadratic:
// 1 - x^2. Cubic: 1 - x^3. Error: 2e-7.
float gloam_falloff_at(uint falloff, float x) {
    if (falloff == GLOAM_FALLOFF_STEP) return x <= 1.0 ? 1.0 : 0.0;
    if (falloff == GLOAM_FALLOFF_QUADRATIC) return max(1.0 - x * x, 0.0);
    if (falloff == GLOAM_FALLOFF_CUBIC) return max(1.0 - x * x * x, 0.0);
    return max(1.0 - x, 0.0);
}

#endif
