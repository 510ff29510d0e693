// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_DISC_TAPS_GLSL
#define GLOAM_OCCLUSION_DISC_TAPS_GLSL

#include "gloam/occlusion/estimator.glsl"
#include "gloam/occlusion/falloff.glsl"

// Contribution of the surface patch seen at a tap, after Fox and Compton's crease shading: no visibility test, the
// patch itself is what blocks.

// contribution of a surface patch (TSSAO-12): `epsilon C = max(cos(s - p, n), 0) epsilon / max(epsilon, |s - p|)`
// [TSSAO, eq 12 corrected; Fox and Compton 2008].
// The printed C is in 1 / length (gloam_contribution_fox_compton_unscaled); times epsilon it is read as occlusion.
// offset: s - p, world units. normal: n, unit vector, same space. epsilon: world units, 0.01 to 0.1 of the kernel
// radius; a negative one counts as 0.
// Returns a contribution in [0, 1]: the cosine within epsilon of p, falling as epsilon / |s - p| beyond; 0 for s = p
// and for a patch in or behind the tangent plane. Error: 3.5e-7.
float gloam_contribution_fox_compton(vec3 offset, vec3 normal, float epsilon) {
    float inverse = inversesqrt(max(dot(offset, offset), GLOAM_LEAST_SQUARE));
    return clamp(dot(offset, normal) * inverse, 0.0, 1.0) * min(max(epsilon, 0.0) * inverse, 1.0);
}

// contribution of a surface patch, in 1 / length (TSSAO-12-unscaled): `C = max(cos(s - p, n), 0) / max(epsilon, |s -
// p|)` [TSSAO, eq 12 corrected; Fox and Compton 2008].
// A length has to multiply its mean before that is occlusion.
// offset: s - p, world units. normal: n, unit vector, same space. epsilon: world units, > 0.
// Returns a contribution in 1 / world units, in [0, 1 / epsilon]; 0 for s = p and for a patch in or behind the tangent
// plane. Error: 4e-7 over the larger of epsilon and |s - p|.
// No method or pass here calls it: it is TSSAO, eq 12, as printed; the method takes it times epsilon.
float gloam_contribution_fox_compton_unscaled(vec3 offset, vec3 normal, float epsilon) {
    float squared = dot(offset, offset);
    float inverse = inversesqrt(max(squared, GLOAM_LEAST_SQUARE));
    return clamp(dot(offset, normal) * inverse, 0.0, 1.0) / max(epsilon, squared * inverse);
}

// ISSAO, the improved screen-space ambient occlusion. The available copies of the paper lack equations 2 to 6. They are
// reconstructed here from its text, which describes an Alchemy-like estimator with its own attenuation. The basic form
// (ISSAO-3) is the cosine-weighted integral (TSSAO-1). The attenuated form (ISSAO-4) is the same with an attenuation by
// distance, and the estimator (ISSAO-6) is the sum over samples.

// ISSAO's contribution of a direction, without attenuation (ISSAO-3): `max(v . n / |v|, 0) for |v| < R` [ISSAO, eq 3,
// reconstructed].
// offset: v = s - p, view space, world units. normal: n, unit vector. radius: R, world units.
// Returns a contribution in [0, 1], for uniform directions: twice its mean is the occlusion. 0 for v = 0, |v| >= R and
// NaN. Error: 4e-7; a point within 4 ULP of the radius may fall to either side.
float gloam_contribution_issao_basic(vec3 offset, vec3 normal, float radius) {
    float reach = dot(offset, gloam_safe_normalize(offset, vec3(0.0)));
    return reach < radius ? gloam_sample_cosine(offset, normal) : 0.0;
}

// ISSAO's attenuation by distance (ISSAO-5): `Q = phi |v| / max(mu, |v|)^2` [ISSAO, eq 5, reconstructed].
// hit_distance: |v|, world units. phi: world units, >= 0, how dark. mu: world units, > 0, bounds the distance from
// below.
// Returns a weight >= 0, at most phi / mu; phi / |v| beyond mu. 0 at distance 0, for mu or the larger of the two
// outside [2^-126, 2^126], for phi not positive, and for NaN in any argument. Error: 5 ULP.
float gloam_issao_attenuation(float hit_distance, float phi, float mu) {
    float d = abs(hit_distance);
    float larger = d > mu ? d : mu;
    if (!(d > 0.0 && phi > 0.0 && mu >= GLOAM_SMALLEST && larger <= GLOAM_LARGEST_DIVISOR)) return 0.0;
    float weight = phi * (d / larger) / larger;
    return weight <= GLOAM_LARGEST ? weight : 0.0;
}

// ISSAO's contribution of a direction (ISSAO-4): `Q(|v|) max(v . n / |v|, 0) for |v| < R` [ISSAO, eq 4, reconstructed].
// offset: v = s - p, view space, world units. normal: n, unit vector. radius: R, world units. phi, mu: see
// gloam_issao_attenuation.
// Returns a contribution in [0, phi / mu], for uniform directions: twice its mean is the occlusion. 0 for v = 0, |v| >=
// R and NaN. Error: 2e-7 of phi / mu; a point within 4 ULP of the radius may fall to either side.
float gloam_contribution_issao_attenuated(vec3 offset, vec3 normal, float radius, float phi, float mu) {
    float reach = dot(offset, gloam_safe_normalize(offset, vec3(0.0)));
    if (!(reach < radius)) return 0.0;
    return gloam_issao_attenuation(reach, phi, mu) * gloam_sample_cosine(offset, normal);
}

// ISSAO's contribution of a tap (ISSAO-6): `lambda phi max(0, v . n - psi) / (v . v + sigma) for |v| < R` [ISSAO, eq 6,
// reconstructed].
// Printed with the gain lambda before the sum over taps (gloam_issao_occlusion); here it is a factor of phi.
// offset: v = s - p, view space, world units. normal: n, unit vector. radius: R, world units. phi: times lambda, world
// units, how dark.
// bias: psi, world units, >= 0, constant or of gloam_depth_bias. sigma: world units squared, > 0, prevents 0 / 0 and
// grows with the scene.
// Returns a contribution >= 0, whose mean is the occlusion; 0 for |v| >= R, in and below the tangent plane raised by
// psi, and for NaN. Error: 4e-7 of phi / |v|.
float gloam_contribution_issao(vec3 offset, vec3 normal, float radius, float phi, float bias, float sigma) {
    float squared = dot(offset, offset);
    float above = dot(offset, normal) - bias;
    float counted = phi * (above / (squared + sigma));
    return above > 0.0 && squared < radius * radius ? counted : 0.0;
}

// ISSAO's occlusion factor (ISSAO-6-mean): `A_0 = min((lambda / s) sum, 1)` [ISSAO, eq 6, reconstructed].
// accumulated: (sum, count) of gloam_estimator_add. lambda: gain of the shadow, >= 0, 1 to 1.06 in the paper's figures.
// Returns occlusion in [0, 1]; 0 for a count below 1 and for NaN. Error: 2.5 ULP.
// No method or pass here calls it: it is ISSAO, eq 6, with lambda where it is printed; the method multiplies each tap.
float gloam_issao_occlusion(vec2 accumulated, float lambda) {
    if (!(accumulated.y >= 1.0 && accumulated.x > 0.0 && lambda > 0.0)) return 0.0;
    float occlusion = lambda * (accumulated.x / accumulated.y);
    return occlusion < 1.0 ? occlusion : (occlusion >= 1.0 ? 1.0 : 0.0);
}

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

// contribution of a surface point (CS-Q): `5 sigma (1 - v^2 / r^2)^3 max(v . n - bias, 0) / (v^2 + epsilon), |v| < r`
// [McGuire, Mara and Luebke 2012 (Scalable Ambient Obscurance)].
// offset: v = s - p, view space, world units. normal: n, unit vector, same space. radius: r, world units. bias: world
// units. epsilon: world units squared, > 0. scale: 5 sigma, world units: sigma is the paper's intensity.
// Returns a contribution >= 0, whose mean is the occlusion; 0 at and beyond the radius, below the plane raised by the
// bias, and for NaN. Error: 7e-7 of the scale over the root of epsilon.
float gloam_contribution_sao(vec3 offset, vec3 normal, float radius, float bias, float epsilon, float scale) {
    float squared = dot(offset, offset);
    float window = 1.0 - squared / (radius * radius);
    float above = dot(offset, normal) - bias;
    if (!(window > 0.0 && above > 0.0)) return 0.0;
    return scale * window * window * window * (above / (squared + epsilon));
}

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

// occlusion from two radii (CS-J-radii): `min(fine + broad, 1)` [Aksoy and Phaneuf 2011, reconstructed].
// fine, broad: occlusion, [0, 1]; outside, the nearer end; 0 for NaN.
// Returns occlusion in [0, 1]. Error: 0.5 ULP.
float gloam_two_radii_sum(float fine, float broad) {
    return min(gloam_unit_interval(fine) + gloam_unit_interval(broad), 1.0);
}

// contribution of a surface point at one level (CS-F): `(1 - min(1, (d / d_max)^2)) max(n . v / |v|, 0)` [Hoang and Low
// 2012 (MSSAO)].
// offset: v = s - p, world units, any space. normal: n, unit vector, same space. radius: d_max, world units, > 0.
// Returns a contribution in [0, 1]; 0 for v = 0, below the tangent plane, at and beyond the radius, for a radius not
// positive, subnormal or NaN, and for what is not finite. Error: 7e-7, for radii of 1e-30 or more.
float gloam_contribution_mssao(vec3 offset, vec3 normal, float radius) {
    return gloam_falloff_quadratic(gloam_length(offset), radius) * gloam_sample_cosine(offset, normal);
}

// occlusion from that of all levels (CS-F-combine): `1 - (1 - max) (1 - mean)` [Hoang and Low 2012 (MSSAO)].
// largest, mean: of the levels' occlusion, [0, 1]; outside, the nearer end; 0 for NaN.
// Returns occlusion in [0, 1]. Error: 2e-7.
float gloam_mssao_combine(float largest, float mean) {
    float a = gloam_unit_interval(largest);
    float b = gloam_unit_interval(mean);
    return min(a + b * (1.0 - a), 1.0);
}

#endif
