// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_SPHERE_PROXY_GLSL
#define GLOAM_OCCLUSION_SPHERE_PROXY_GLSL

#include "gloam/geometry/length.glsl"
#include "gloam/numeric/length_ratio.glsl"
#include "gloam/numeric/square_root.glsl"
#include "gloam/occlusion/cosine.glsl"

// A ball that replaces the surface at a tap (Shanmugam and Arikan 2007; mixture sampling, Song 2010). Its radius r is
// half the width of the tap's pixel in the world: gloam_filter_sigma with half a pixel. Overlapping balls count twice,
// so clamp the sum.

// part of the half space that a ball takes up (CS-H-fraction): `1 - sqrt(1 - (r / D)^2)` [solid angle of a ball].
// Part of the half space that a ball seen from outside takes up: 1 - sqrt(1 - (r / D)^2), by solid angle.
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
// Exact for a ball above the tangent plane.
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

#endif
