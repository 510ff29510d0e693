// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_BLOCKED_GLSL
#define GLOAM_OCCLUSION_BLOCKED_GLSL

#include "gloam/occlusion/gather_kernel.glsl"

// whether the depth buffer blocks a sample point (TSSAO-3-V): `V = 1 if bias < d_s - d_b <= range, else 0` [TSSAO,
// eq 3 in screen space].
// It does where the surface at the sample's pixel is nearer to the eye than the sample by more than the bias, but not
// by more than the range. A surface further in front is taken for another object, with open space behind it.
// sample_depth: eye-linear depth of the sample, world units. buffer_depth: eye-linear depth at its pixel, world units.
// bias: world units, no less than the spacing of depths (gather_kernel.glsl): hides the rounding of positions and
// depths.
// range: world units, about the kernel radius; infinity switches the check off, a range not above the bias blocks
// nothing.
// Returns whether bias < sample_depth - buffer_depth <= range: false for background in the buffer, as gloam_tap_sees
// reads it, and for NaN. Error: the difference is that of two depths rounded once (exact within a factor 2), and may
// fall to either side of a threshold within 1 ULP of it.
bool gloam_sample_blocked(float sample_depth, float buffer_depth, float bias, float range) {
    float in_front = sample_depth - buffer_depth;
    return gloam_tap_sees(buffer_depth) && in_front > bias && in_front <= range;
}

#endif
