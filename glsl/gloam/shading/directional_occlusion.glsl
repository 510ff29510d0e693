// SPDX-License-Identifier: MIT
#ifndef GLOAM_SHADING_DIRECTIONAL_OCCLUSION_GLSL
#define GLOAM_SHADING_DIRECTIONAL_OCCLUSION_GLSL

#include "gloam/geometry/length.glsl"
#include "gloam/numeric/constants.glsl"
#include "gloam/occlusion/cosine.glsl"
#include "gloam/sampling/unit_interval.glsl"

// Screen-space directional occlusion (Ritschel, Grosch and Seidel 2009): light that comes from the directions in which
// the point is open, and one bounce off what blocks the others. Sum the terms of all samples, then gloam_ssdo_light.

// radiance that can be summed (CS-D-radiance): `clamp(L, 0, 65504)` [convention].
// Radiance that can be summed: components that are negative or NaN count as 0, those above 65504 (the largest 16-bit
// float) as that.
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
