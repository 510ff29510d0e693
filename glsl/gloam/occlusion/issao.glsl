// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_ISSAO_GLSL
#define GLOAM_OCCLUSION_ISSAO_GLSL

#include "gloam/numeric/constants.glsl"
#include "gloam/occlusion/cosine.glsl"

// ISSAO, the improved screen-space ambient occlusion. The available copies of the paper lack equations 2 to 6. They are
// reconstructed here from its text, which describes an Alchemy-like estimator with its own attenuation. The basic form
// (ISSAO-3) is the cosine-weighted integral (TSSAO-1). The attenuated form (ISSAO-4) is the same with an attenuation by
// distance, and the estimator (ISSAO-6) is the sum over samples.

// ISSAO's contribution of a direction, without attenuation (ISSAO-3): `max(v . n / |v|, 0) for |v| < R` [ISSAO, eq 3,
// reconstructed].
// offset: v = s - p, view space, world units. normal: n, unit vector. radius: R, world units.
// Returns a contribution in [0, 1], for uniform directions: twice its mean is the occlusion. 0 for v = 0, |v| >= R and
// NaN.
// Error: 4e-7; a point within 4 ULP of the radius may fall to either side.
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
// Returns a contribution in [0, phi / mu], for uniform directions: twice its mean is the occlusion. 0 for v = 0, |v|
// >= R and NaN.
// Error: 2e-7 of phi / mu; a point within 4 ULP of the radius may fall to either side.
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

#endif
