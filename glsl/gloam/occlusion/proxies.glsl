// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_PROXIES_GLSL
#define GLOAM_OCCLUSION_PROXIES_GLSL

#include "gloam/geometry/vector.glsl"
#include "gloam/numeric/arithmetic.glsl"
#include "gloam/occlusion/estimator.glsl"

// A ball that replaces the surface at a tap (Shanmugam and Arikan 2007; mixture sampling, Song 2010). Its radius r is
// half the width of the tap's pixel in the world: gloam_filter_sigma with half a pixel. Overlapping balls count twice,
// so clamp the sum.

// part of the half space that a ball takes up (CS-H-fraction): `1 - sqrt(1 - (r / D)^2)` [solid angle of a ball].
// radius: r, distance_to: D of the centre, world units, same unit.
// Returns a fraction in [0, 1]; 1 for D <= r, 0 for an r not positive and for NaN. Error: 3e-7.
float gloam_sphere_fraction(float radius, float distance_to) {
    if (!(radius > 0.0 && distance_to >= 0.0)) return 0.0;
    if (distance_to <= radius) return 1.0;
    float x = gloam_length_ratio(radius, distance_to);
    // 1 - x, exact where it is small: the square root would magnify what rounding leaves of it.
    float gap = gloam_length_ratio(distance_to - radius, distance_to);
    return min(x * x / (1.0 + gloam_sqrt(gap * (1.0 + x))), 1.0);
}

// contribution of a ball by its solid angle (CS-H): `(1 - sqrt(1 - (r / D)^2)) max(n . v / D, 0)` [Shanmugam and Arikan
// 2007; Song 2010 (mixture sampling)].
// offset: v, from the point to the centre, world units. normal: n, unit vector, same space. radius: r, world units, >
// 0.
// Returns a contribution in [0, 1]; 1 for a point inside the ball, 0 for a centre below the tangent plane, for an r
// not positive and for what is not finite. Error: 8e-7 for D > 1.05 r; nearer to the ball the square root magnifies
// the error of D.
float gloam_contribution_sphere(vec3 offset, vec3 normal, float radius) {
    if (!gloam_is_finite3(offset)) return 0.0;
    float reach = gloam_length(offset);
    float fraction = gloam_sphere_fraction(radius, reach);
    return reach <= radius ? fraction : fraction * gloam_sample_cosine(offset, normal);
}

// contribution of a ball, cosine-weighted (CS-H-cosine): `(r / D)^2 max(n . v / D, 0)` [derived: exact for a ball above
// the tangent plane].
// offset: v, from the point to the centre, world units. normal: n, unit vector, same space. radius: r, world units, >
// 0.
// Returns a contribution in [0, 1]; 1 and 0 as gloam_contribution_sphere. Error: 5e-7, but within rounding of D = r.
float gloam_contribution_sphere_cosine(vec3 offset, vec3 normal, float radius) {
    if (!(gloam_is_finite3(offset) && radius > 0.0)) return 0.0;
    float reach = gloam_length(offset);
    if (reach <= radius) return 1.0;
    float x = gloam_length_ratio(radius, reach);
    return x * x * gloam_sample_cosine(offset, normal);
}

// whether a proxy stands above the horizon (CS-H-above): `v_z > tan(h) |v_xy|` [Song 2010 (mixture sampling)].
// Only there it blocks directions that the horizon does not (mixture sampling).
// offset: from the point to the centre, view space, world units. tan_horizon: tangent of the horizon's elevation over
// the image plane, the larger where the point is nearer to the eye.
// Returns 1 if offset.z > tan_horizon |offset.xy|, else 0; straight towards the eye is above every horizon. 0 for an
// offset that is not finite, and off that axis for a horizon that is NaN or +infinity. Error: none, but for a centre
// within rounding of the horizon.
float gloam_above_horizon(vec3 offset, float tan_horizon) {
    float across = gloam_length(vec3(offset.xy, 0.0));
    float horizon = across > 0.0 ? across * tan_horizon : 0.0;
    return gloam_is_finite3(offset) && offset.z > horizon ? 1.0 : 0.0;
}

// Object-space occlusion (Bunnell, GPU Gems 2; Hoberock and Jia, GPU Gems 3): every element of the scene is a disc.
// Sum the contributions of all discs and clamp. A second pass, in which each disc is weighted with its own visibility
// from the first, takes back what hidden discs added.

// how a disc shares the squared distance to its rim (CS-S-share): `(A, pi D^2) / (A + pi D^2)` [derived].
// area: A, world units squared, >= 0. distance_to: D of the centre, world units, >= 0.
// Returns (a, 1 - a), each in [0, 1]; (0, 1) for an area not positive or NaN, and for a distance that is negative or
// NaN. Error: 4e-7.
vec2 gloam_disc_share(float area, float distance_to) {
    float radius = gloam_sqrt(area * 0.318309886);
    if (!(radius > 0.0 && distance_to >= 0.0)) return vec2(0.0, 1.0);
    bool wide = radius > distance_to;
    float x = gloam_length_ratio(wide ? distance_to : radius, wide ? radius : distance_to);
    float larger = 1.0 / (1.0 + x * x);
    float smaller = x * x / (1.0 + x * x);
    return min(wide ? vec2(larger, smaller) : vec2(smaller, larger), vec2(1.0));
}

// contribution of a disc of the scene, cosine-weighted (CS-S-cosine): `A / (A + pi D^2) max(-n_E . v / D, 0) max(n . v
// / D, 0)` [derived: exact on the axis].
// Exact for a disc above the point and parallel to its tangent plane.
// offset: v, from the point to the disc, world units. normal: n, unit vector, same space. emitter_normal: n_E, of the
// disc, unit vector.
// area: A, world units squared, > 0. weight: visibility of the disc from the pass before, 1 in the first; [0, 1].
// Returns a contribution in [0, 1]; 0 for a disc that faces away or lies below the tangent plane, for v = 0 and for
// what is not finite. Error: 6e-7.
float gloam_contribution_disc_proxy_cosine(vec3 offset, vec3 normal, vec3 emitter_normal, float area, float weight) {
    float share = gloam_disc_share(area, gloam_length(offset)).x;
    return gloam_unit_interval(weight) * share * gloam_sample_cosine(-offset, emitter_normal) *
           gloam_sample_cosine(offset, normal);
}

#endif
