// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_MSSAO_GLSL
#define GLOAM_OCCLUSION_MSSAO_GLSL

#include "gloam/geometry/length.glsl"
#include "gloam/occlusion/cosine.glsl"
#include "gloam/occlusion/falloff.glsl"
#include "gloam/sampling/unit_interval.glsl"

// Multi-resolution ambient occlusion (Hoang and Low 2010, 2012): a small kernel at each of several resolutions, where
// the coarser kernels cover more of the world, and the combination of their results.

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
