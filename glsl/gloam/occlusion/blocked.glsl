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

// bias that grows with the depth (BIAS-depth): `b d / d_ref` [McGuire et al. 2011; psi(z) of ISSAO, eq 6].
// Against self-occlusion: the rounding error of positions grows so, too. It is the psi(z) of the improved method
// (ISSAO-6), and with d_ref = 1 the beta z of Alchemy's estimator (CS-3.10). That one prints + beta; z is negative in
// view space, so the bias is subtracted.
// bias: b, world units at the reference depth, >= 0. depth: d, eye-linear, world units. reference_depth: d_ref, world
// units, > 0.
// Returns a length in world units, in [0, FLT_MAX]; 0 for background depth, and for b or d_ref that is not positive
// or NaN. The contributions subtract it from the height above the tangent plane. Error: 2.5 ULP.
float gloam_depth_bias(float bias, float depth, float reference_depth) {
    if (gloam_is_background(depth) ||
        !(bias > 0.0 && reference_depth >= GLOAM_SMALLEST && reference_depth <= GLOAM_LARGEST_DIVISOR))
        return 0.0;
    float scaled = bias * (depth / reference_depth);
    return scaled <= GLOAM_LARGEST ? scaled : (scaled > 0.0 ? GLOAM_LARGEST : 0.0);
}

#endif
