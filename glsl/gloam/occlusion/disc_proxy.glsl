// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_DISC_PROXY_GLSL
#define GLOAM_OCCLUSION_DISC_PROXY_GLSL

#include "gloam/geometry/length.glsl"
#include "gloam/numeric/length_ratio.glsl"
#include "gloam/numeric/square_root.glsl"
#include "gloam/occlusion/cosine.glsl"
#include "gloam/sampling/unit_interval.glsl"

// Object-space occlusion (Bunnell, GPU Gems 2; Hoberock and Jia, GPU Gems 3): every element of the scene is a disc.
// Sum the contributions of all discs and clamp. A second pass, in which each disc is weighted with its own visibility
// from the first, takes back what hidden discs added.

// how a disc shares the squared distance to its rim (CS-S-share): `(A, pi D^2) / (A + pi D^2)` [derived].
// area: A, world units squared, >= 0. distance_to: D of the centre, world units, >= 0.
// Returns (a, 1 - a), each in [0, 1]; (0, 1) for an area not positive or NaN, and for a distance that is negative or
// NaN.
// Error: 4e-7.
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
