// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_DEPTH_REJECTION_GLSL
#define GLOAM_OCCLUSION_DEPTH_REJECTION_GLSL

#include "gloam/occlusion/gather_kernel.glsl"

// whether a tap lies too far in front (CS-REJ): `d_p - d_s > threshold` [Aalund and Baerentzen 2013].
// Such a surface is not near the point. A rejected tap is skipped, or replaced by its opposite.
// depth: d_p, of the shaded point, eye-linear, world units. tap_depth: d_s, at the tap. threshold: world units, about
// the radius.
// Returns true for a surface in front by more than the threshold; false for background on either side (nothing is in
// front), as gloam_tap_sees reads it, and for a NaN threshold. Error: none, except for a difference within rounding of
// the threshold.
bool gloam_tap_rejected(float depth, float tap_depth, float threshold) {
    return gloam_tap_sees(depth) && gloam_tap_sees(tap_depth) && depth - tap_depth > threshold;
}

#endif
