// SPDX-License-Identifier: MIT
#ifndef GLOAM_SHADING_DIRECTIONAL_GLSL
#define GLOAM_SHADING_DIRECTIONAL_GLSL

#include "gloam/geometry/vector.glsl"
#include "gloam/numeric/inverse_trigonometry.glsl"
#include "gloam/occlusion/estimator.glsl"

// Bent normal (Klehm et al. 2011): the mean of the directions in which the point is open, from the samples of any
// estimator that has directions.

// one more direction in a bent normal (CS-L-add): `(sum of V w + V w, sum of V + V)` [Klehm et al. 2011].
// bent: (sum of V w, sum of V) so far, starting at 0. direction: w, unit vector, any space; of uniform density for
// the cones of gloam_cone_angle. visibility: V in [0, 1], 1 open; outside, the nearer end; 0 for NaN.
// Returns the sums with the direction; unchanged for a direction that is not finite. Error: 1 ULP of the sums for
// each addition.
vec4 gloam_bent_add(vec4 bent, vec3 direction, float visibility) {
    return gloam_is_finite3(direction) ? bent + gloam_unit_interval(visibility) * vec4(direction, 1.0) : bent;
}

// bent normal (CS-L): `b = sum of V w / |sum of V w|` [Klehm et al. 2011].
// bent: sums of gloam_bent_add. normal: unit vector, for where nothing is open or the open directions cancel.
// Returns a unit vector, or the normal. Error: 3 ulp in each component.
vec3 gloam_bent_normal(vec4 bent, vec3 normal) {
    return bent.w > 0.0 ? gloam_safe_normalize(bent.xyz, normal) : normal;
}

// how much the open directions agree (CS-L-length): `L = |sum of V w| / sum of V` [Klehm et al. 2011].
// 1/2 for an open hemisphere, 1 for a single direction.
// bent: sums of gloam_bent_add.
// Returns L in [0, 1]; 1 where nothing is open, so that no cone is left, and for a sum of V above 2^126; 0 where the
// sum of V w is not finite. Error: 4e-7 for sums from 1e-18 to 1e18.
float gloam_bent_length(vec4 bent) {
    bool some = bent.w >= GLOAM_SMALLEST && bent.w <= GLOAM_LARGEST_DIVISOR;
    float agreement = some ? gloam_length(bent.xyz) / bent.w : 1.0;
    return agreement < 1.0 ? agreement : 1.0;
}

// Half angle of the cone around the bent normal that stands for the open directions.

// half angle of the open cone, exact for a cap (CS-L-cone): `arccos(max(0, 2 L - 1))` [derived: L = (1 + cos a) / 2].
// agreement: L of gloam_bent_length, [0, 1]; outside, the nearer end; 0 for NaN.
// Returns radians in [0, pi / 2]: an L below 1/2 is not that of a cap, and gives pi / 2. Error: 4e-7.
float gloam_cone_angle(float agreement) {
    return gloam_acos(max(2.0 * gloam_unit_interval(agreement) - 1.0, 0.0));
}

// Screen-space directional occlusion (Ritschel, Grosch and Seidel 2009): light that comes from the directions in which
// the point is open, and one bounce off what blocks the others. Sum the terms of all samples, then gloam_ssdo_light.

// radiance that can be summed (CS-D-radiance): `clamp(L, 0, 65504)` [convention].
// Components that are negative or NaN count as 0, those above 65504 (the largest 16-bit float) as that.
// radiance: any unit. Returns components in [0, 65504]. Error: none.
vec3 gloam_ssdo_radiance(vec3 radiance) {
    return vec3(radiance.x > 0.0 ? min(radiance.x, 65504.0) : 0.0, radiance.y > 0.0 ? min(radiance.y, 65504.0) : 0.0,
                radiance.z > 0.0 ? min(radiance.z, 65504.0) : 0.0);
}

// light along one direction (CS-D): `2 L V max(w . n, 0)` [Ritschel, Grosch and Seidel 2009 (SSDO)].
// Its mean over directions uniform on the hemisphere is the irradiance over pi.
// direction: w, of any length. normal: n, unit vector, same space. radiance: L, that arrives along w. visibility: V
// in [0, 1], 1 open; outside, the nearer end; 0 for NaN.
// Returns a term >= 0 in the unit of L, at most 2 L; 0 below the surface and for what is not finite. Error: 6e-7 of L.
vec3 gloam_ssdo_direct(vec3 direction, vec3 normal, vec3 radiance, float visibility) {
    return 2.0 * gloam_unit_interval(visibility) * gloam_sample_cosine(direction, normal) *
           gloam_ssdo_radiance(radiance);
}

// light that one blocked sample bounces (CS-D-bounce): `(1 - V) L R^2 max(cos_s, 0) max(cos_r, 0) / max(d, d_min)^2`
// [Ritschel, Grosch and Seidel 2009 (SSDO)].
// The surface that blocks stands for the N-th part of a disc of the kernel's radius R, area pi R^2 / N.
// offset: from the point to the surface that blocks, world units, d = |offset|. normal: of the point, unit vector.
// sender_normal: of the surface, unit vector. radiance: L, that it sends. radius: R, world units, > 0.
// least_distance: d_min, world units, > 0 (1 in print).
// visibility: V in [0, 1] of the sample; outside, the nearer end; 0 for NaN.
// Returns a term >= 0 in the unit of L, at most 1024^2 L: R / max(d, d_min) is taken to at most 1024. 0 for d = 0,
// where either surface faces away, for a radius or least distance that is not in [2^-126, 2^126], and for what is not
// finite. Error: 6e-7 of L (R / max(d, d_min))^2.
vec3 gloam_ssdo_bounce(vec3 offset, vec3 normal, vec3 sender_normal, vec3 radiance, float radius, float least_distance,
                       float visibility) {
    float reach = max(gloam_length(offset), least_distance);
    bool sized = radius >= GLOAM_SMALLEST && least_distance >= GLOAM_SMALLEST && reach <= GLOAM_LARGEST_DIVISOR;
    if (!sized) return vec3(0.0);
    float ratio = min(radius / reach, 1024.0);
    float cosines = gloam_sample_cosine(offset, normal) * gloam_sample_cosine(-offset, sender_normal);
    return (1.0 - gloam_unit_interval(visibility)) * cosines * (ratio * ratio) * gloam_ssdo_radiance(radiance);
}

// light that leaves the point (CS-D-light): `rho sum / N` [Ritschel, Grosch and Seidel 2009 (SSDO)].
// sum: of the terms of gloam_ssdo_direct or of gloam_ssdo_bounce, each component in [0, FLT_MAX]. count: of the
// samples, blocked ones included. albedo: rho, diffuse, [0, 1]; outside, the nearer end; 0 for NaN.
// Returns radiance >= 0; 0 for a count outside [1, 2^24] and for components of the sum that are negative or not
// finite. Error: 3 ULP.
vec3 gloam_ssdo_light(vec3 sum, float count, vec3 albedo) {
    if (!(count >= 1.0 && count <= 16777216.0)) return vec3(0.0);
    vec3 inside = vec3(gloam_unit_interval(albedo.x), gloam_unit_interval(albedo.y), gloam_unit_interval(albedo.z));
    vec3 mean = vec3(sum.x >= 0.0 && sum.x <= GLOAM_LARGEST ? sum.x : 0.0,
                     sum.y >= 0.0 && sum.y <= GLOAM_LARGEST ? sum.y : 0.0,
                     sum.z >= 0.0 && sum.z <= GLOAM_LARGEST ? sum.z : 0.0) /
                count;
    return inside * mean;
}

#endif
