// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_AKSOY_PHANEUF_GLSL
#define GLOAM_OCCLUSION_AKSOY_PHANEUF_GLSL

#include "gloam/geometry/length.glsl"
#include "gloam/occlusion/falloff.glsl"
#include "gloam/sampling/unit_interval.glsl"

// Poisson-disc occlusion after Aksoy and Phaneuf 2011: surface points under the taps of a disc, at a fine and at a
// broad radius.

// contribution of a surface point in front of the tangent plane (CS-J): `max(1 - |v| / R, 0) if v . n > bias, else 0`
// [Aksoy and Phaneuf 2011, corrected].
// Contribution of a surface point: max(1 - |v| / R, 0) where it lies in front of the tangent plane, v . n > bias. (In
// print points BEHIND the plane occlude; they cannot.)
// offset: v = s - p, world units. normal: n, unit vector, same space. radius: R, world units, > 0. bias: world units,
// >= 0.
// Returns a contribution in [0, 1]; 0 on and behind the plane, at and beyond the radius, for a radius not positive,
// subnormal or NaN, and for what is not finite. Error: 4e-7, but for points within rounding of the plane.
// No method or pass here calls it: it is there to be copied.
float gloam_contribution_aksoy_phaneuf(vec3 offset, vec3 normal, float radius, float bias) {
    bool in_front = gloam_is_finite3(offset) && dot(offset, normal) > bias;
    return in_front ? gloam_falloff_linear(gloam_length(offset), radius) : 0.0;
}

// occlusion from two radii (CS-J-radii): `min(fine + broad, 1)` [Aksoy and Phaneuf 2011, corrected].
// Occlusion from two radii, their sum clamped: min(fine + broad, 1). (gloam_layers_occlusion is the other choice, the
// larger of the two.)
// fine, broad: occlusion, [0, 1]; outside, the nearer end; 0 for NaN.
// Returns occlusion in [0, 1]. Error: 0.5 ULP.
float gloam_two_radii_sum(float fine, float broad) {
    return min(gloam_unit_interval(fine) + gloam_unit_interval(broad), 1.0);
}

#endif
