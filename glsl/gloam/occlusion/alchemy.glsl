// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_ALCHEMY_GLSL
#define GLOAM_OCCLUSION_ALCHEMY_GLSL

#include "gloam/numeric/constants.glsl"
#include "gloam/shading/remap.glsl"

// Alchemy ambient obscurance (McGuire et al. 2011; CS-3.6 to 3.10). With the falloff u d / max(u, d)^2 the obscurance
// integral turns into an average of (v . n) / (v . v) over surface points: no direction is normalised and no ray is
// traced.

// Alchemy's contribution of a surface point, in 1 / length (CS-M): `C = max(v . n - bias, 0) / (v . v + epsilon)`
// [McGuire et al. 2011; Aalund and Baerentzen 2013, eqs 3.6 to 3.10].
// offset: v = s - p, view space, world units. normal: n, unit vector, same space. bias: world units, >= 0, constant
// or of gloam_depth_bias.
// epsilon: world units squared, >= 0: bounds what a touching point counts.
// Returns a contribution in 1 / world units, >= 0, for gloam_visibility_alchemy. 0 in and below the tangent plane
// raised by the bias, for v = 0, for v . v + epsilon outside [2^-126, 2^126], and for NaN in any argument. Error:
// 3e-7 / |v| (3e-6 from |v| = 0.1 on).
// No method or pass here calls it: it is there to be copied.
float gloam_contribution_alchemy(vec3 offset, vec3 normal, float bias, float epsilon) {
    float above = dot(offset, normal) - bias;
    float denominator = dot(offset, offset) + epsilon;
    if (!(above > 0.0 && epsilon >= 0.0 && denominator >= GLOAM_SMALLEST && denominator <= GLOAM_LARGEST_DIVISOR))
        return 0.0;
    float contribution = above / denominator;
    return contribution <= GLOAM_LARGEST ? contribution : 0.0;
}

// visibility from Alchemy's contributions (CS-M-visibility): `max(0, 1 - (2 sigma / N) sum)^k` [McGuire et al. 2011;
// Aalund and Baerentzen 2013, eqs 3.6 to 3.10].
// The printed equation (CS-3.10) lost the factor 2 sigma.
// accumulated: (sum, count) of gloam_estimator_add, the sum in 1 / world units. sigma: world units, >= 0, the
// distance of the strongest influence (u of the falloff), which is also the intensity. k: contrast, > 0; 1 leaves the
// estimate.
// Returns visibility in [0, 1], 1 = open; 1 for a count below 1 and for NaN in any argument. Error: 3e-7 for k = 1,
// and that of gloam_remap.
// No method or pass here calls it: it is there to be copied.
float gloam_visibility_alchemy(vec2 accumulated, float sigma, float k) {
    if (!(accumulated.y >= 1.0 && accumulated.x > 0.0)) return 1.0;
    return gloam_remap(1.0 - 2.0 * sigma * (accumulated.x / accumulated.y), 0.0, 1.0, k);
}

#endif
