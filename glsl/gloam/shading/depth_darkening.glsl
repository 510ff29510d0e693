// SPDX-License-Identifier: MIT
#ifndef GLOAM_SHADING_DEPTH_DARKENING_GLSL
#define GLOAM_SHADING_DEPTH_DARKENING_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/numeric/constants.glsl"

// depth darkening (CS-R): `lambda min(G * D - D, 0)` [Luft, Colditz and Deussen 2006].
// The unsharp mask of the depth buffer, to be added to the colour. It darkens what lies behind a nearer object, next to
// its outline; it is no occlusion, but was what came before.
// depth: D, eye-linear, any unit (parts of the scene's depth are usual). blurred_depth: G * D, a wide Gaussian of the
// same image. strength: lambda, colour per unit of depth, >= 0.
// Returns a number <= 0, not below -FLT_MAX; 0 for background on either side, and for a strength not positive or NaN.
// Error: 2 ULP of lambda times the larger depth.
float gloam_depth_darkening(float depth, float blurred_depth, float strength) {
    if (gloam_is_background(depth) || gloam_is_background(blurred_depth) || !(strength > 0.0)) return 0.0;
    float difference = blurred_depth - depth;
    return difference < 0.0 ? max(strength * difference, -GLOAM_LARGEST) : 0.0;
}

#endif
