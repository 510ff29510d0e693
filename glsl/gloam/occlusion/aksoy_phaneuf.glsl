// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_AKSOY_PHANEUF_GLSL
#define GLOAM_OCCLUSION_AKSOY_PHANEUF_GLSL

#include "gloam/numeric/constants.glsl"
#include "gloam/sampling/unit_interval.glsl"

// Poisson-disc occlusion after Aksoy and Phaneuf 2011: surface points under the taps of a disc, at a fine and at a
// broad radius.

// contribution of a surface point in front of the tangent plane (CS-J): `max(1 - |v| / R, 0) if v . n > bias, else 0`
// [Aksoy and Phaneuf 2011, corrected].
// (In print points BEHIND the plane occlude; they cannot.)
// offset: v = s - p, world units. normal: n, unit vector, same space. radius: R, world units, > 0. bias: world units,
// >= 0.
// Returns a contribution in [0, 1]; 0 on and behind the plane and from the radius on. Error: 4e-7, but for points
// within rounding of the plane.
float gloam_contribution_aksoy_phaneuf(vec3 offset, vec3 normal, float radius, float bias) {
    float squared = dot(offset, offset);
    float weight = 1.0 - squared * inversesqrt(max(squared, GLOAM_LEAST_SQUARE)) / radius;
    return dot(offset, normal) > bias ? max(weight, 0.0) : 0.0;
}

// occlusion from two radii (CS-J-radii): `min(fine + broad, 1)` [Aksoy and Phaneuf 2011, corrected].
// fine, broad: occlusion, [0, 1]; outside, the nearer end; 0 for NaN.
// Returns occlusion in [0, 1]. Error: 0.5 ULP.
float gloam_two_radii_sum(float fine, float broad) {
    return min(gloam_unit_interval(fine) + gloam_unit_interval(broad), 1.0);
}

#endif
