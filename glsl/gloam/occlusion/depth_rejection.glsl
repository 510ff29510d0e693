// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_DEPTH_REJECTION_GLSL
#define GLOAM_OCCLUSION_DEPTH_REJECTION_GLSL

#include "gloam/geometry/background.glsl"

// Whether a tap tells nothing of the surroundings of its point, because what it sees lies too far in front (CS-REJ):
// d_p - d_s > threshold. Such a tap is left out, or replaced by its opposite.
// depth: d_p, of the shaded point, eye-linear, world units. tap_depth: d_s, at the tap. threshold: world units, about
// the radius.
// Returns whether to leave the tap out: true for one in front by more than the threshold, false for background on
// either side (there is nothing in front) and for a NaN threshold. Error: none, but for a difference within rounding
// of the threshold.
bool gloam_tap_rejected(float depth, float tap_depth, float threshold) {
    if (gloam_is_background(depth) || gloam_is_background(tap_depth)) return false;
    return depth - tap_depth > threshold;
}

#endif
