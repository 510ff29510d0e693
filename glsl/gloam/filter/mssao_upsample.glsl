// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_MSSAO_UPSAMPLE_GLSL
#define GLOAM_FILTER_MSSAO_UPSAMPLE_GLSL

#include "gloam/geometry/finite.glsl"
#include "gloam/sampling/unit_interval.glsl"
#include "gloam/shading/remap.glsl"

// weight of a pixel of the coarser level (CS-F-upsample): `bilinear (1 / (1 + |dz|))^a ((n . n' + 1) / 2)^b` [Hoang and
// Low 2012 (MSSAO)].
// For gloam_weighted_mean_add.
// bilinear: weight by position, [0, 1]; outside, the nearer end; 0 for NaN. depth_difference: dz, world units, below
// 1e30. normal_cosine: n . n'; taken into [-1, 1]. depth_power, normal_power: a, b, in [0, 16].
// Returns a weight in [0, 1]; 0 for opposite normals (with b > 0), for a NaN and for depths 1e30 apart. Error: 3e-6.
float gloam_mssao_upsample_weight(float bilinear, float depth_difference, float normal_cosine, float depth_power,
                                  float normal_power) {
    float apart = abs(depth_difference);
    bool known = apart <= 1e30 && !gloam_is_nan(normal_cosine) && depth_power >= 0.0 && normal_power >= 0.0;
    if (!known) return 0.0;
    float depth = gloam_remap(1.0 / (1.0 + apart), 0.0, 1.0, depth_power);
    float facing = gloam_unit_interval(0.5 * normal_cosine + 0.5);
    float normal = gloam_remap(facing, 0.0, 1.0, normal_power);
    return gloam_unit_interval(bilinear) * depth * normal;
}

#endif
