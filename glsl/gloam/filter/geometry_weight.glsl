// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_GEOMETRY_WEIGHT_GLSL
#define GLOAM_FILTER_GEOMETRY_WEIGHT_GLSL

#include "gloam/numeric/constants.glsl"

// weight of a neighbour by normal and depth (CS-BLUR-weight): `(n_0 . n_i / 2 + 1/2)^p_n (1 + |z_0 - z_i|)^-p_z`
// [Aalund and Baerentzen 2013, geometry-aware blur].
// It knows no distance in the image.
// normal, other: unit vectors, same space. depth_difference: z_0 - z_i, world units. normal_power: p_n, > 0, 10.
// position_power: p_z, >= 0, 0.5, for the units of the scene.
// Returns a weight in [0, 1]; 1 for the same normal and depth, (1/2)^p_n of the depth's for a zero normal, 0 for
// opposite normals, an infinite difference, and NaN. Error: 3e-6.
float gloam_geometry_weight(vec3 normal, vec3 other, float depth_difference, float normal_power, float position_power) {
    float facing = 0.5 * dot(normal, other) + 0.5;
    float apart = 1.0 + abs(depth_difference);
    if (!(facing > 0.0 && apart <= GLOAM_LARGEST && normal_power > 0.0 && position_power >= 0.0)) return 0.0;
    // One power for both: 2^(p_n log2(facing) - p_z log2(apart)).
    float by_normal = facing < 1.0 ? normal_power * log2(facing) : 0.0;
    float by_depth = apart > 1.0 ? position_power * log2(apart) : 0.0;
    float x = by_normal - by_depth;
    float weight = min(exp2(x), 1.0);
    return x >= -99.5 ? weight : 0.0;
}

#endif
