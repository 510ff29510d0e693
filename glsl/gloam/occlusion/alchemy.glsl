// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_ALCHEMY_GLSL
#define GLOAM_OCCLUSION_ALCHEMY_GLSL

// Alchemy ambient obscurance (McGuire et al. 2011; CS-3.6 to 3.10). With the falloff u d / max(u, d)^2 the obscurance
// integral turns into an average of (v . n) / (v . v) over surface points: no direction is normalised and no ray is
// traced.

// Alchemy's contribution of a surface point (CS-M): `C = 2 sigma max(v . n - bias, 0) / (v . v + epsilon)` [McGuire et
// al. 2011; Aalund and Baerentzen 2013, eqs 3.6 to 3.10].
// The printed equation (CS-3.10) lost the factor 2 sigma. Its exponent k is the contrast of gloam_remap.
// offset: v = s - p, view space, world units. normal: n, unit vector, same space. bias: world units, >= 0, constant
// or of gloam_depth_bias. epsilon: world units squared, > 0: bounds what a touching point counts. scale: 2 sigma, world
// units: sigma is the distance of the strongest influence (u of the falloff), and the intensity.
// Returns a contribution >= 0, whose mean is the occlusion; 0 in and below the tangent plane raised by the bias, and
// for NaN. Error: 3e-7 of the scale over |v| (3e-6 from |v| = 0.1 on).
float gloam_contribution_alchemy(vec3 offset, vec3 normal, float bias, float epsilon, float scale) {
    float above = dot(offset, normal) - bias;
    float counted = scale * (above / (dot(offset, offset) + epsilon));
    return above > 0.0 ? counted : 0.0;
}

#endif
