// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_RESOLUTION_GLSL
#define GLOAM_FILTER_RESOLUTION_GLSL

#include "gloam/geometry/vector.glsl"
#include "gloam/shading/ambient.glsl"

// Which pixels an image of half the resolution stands for: its pixel p has what pixel 2 p of the full image has, not
// that of a point between four pixels. A side of n pixels becomes (n + 1) / 2, so odd sizes need no special case.

// size of an image of half the resolution (HALF-size): `(n + 1) / 2, rounded down` [definition].
// size: of the full image, pixels, 0 to 2^30.
// Error: none.
ivec2 gloam_half_size(ivec2 size) {
    return (size + 1) / 2;
}

// full-size pixel that a half-size pixel stands for (HALF-source): `2 p` [definition].
// pixel: of the half-size image, within 2^30 of 0.
// Error: none.
ivec2 gloam_half_source(ivec2 pixel) {
    return 2 * pixel;
}

// The next coarser level of MSSAO: of four pixels the two middle ones in depth, or the second where they lie on
// different surfaces.

// place of one of four depths in their order (CS-F-rank): `how many are smaller, or equal and before it` [definition].
// depths: d_0 to d_3, not NaN. index: of the one asked for, 0 to 3; outside, the nearer end. Returns 0 to 3. Error:
// none.
int gloam_depth_rank(vec4 depths, int index) {
    int own = clamp(index, 0, 3);
    float depth = depths[own];
    int rank = 0;
    for (int i = 0; i < 4; ++i) {
        if (depths[i] < depth || (depths[i] == depth && i < own)) ++rank;
    }
    return rank;
}

// weights of four pixels in the one that stands for them (CS-F-weights): `z_4 - z_1 <= tolerance: (0, 1/2, 1/2, 0),
// else (0, 1, 0, 0), by depth` [Hoang and Low 2012 (MSSAO)].
// depths: eye-linear, world units, of a 2 x 2 block in any order. Background is behind everything, and is chosen only
// if all four are background.
// tolerance: world units, >= 0: largest range of depths of one surface.
// Returns the weight of each, in the same order, summing to 1. Of equal depths the one with the lower index comes
// first. All 0 for four background pixels; one for the only surface. A NaN tolerance selects the second. Error: none,
// except that depths with a range within rounding of the tolerance may be judged either way.
vec4 gloam_mssao_weights(vec4 depths, float tolerance) {
    vec4 d = depths;
    int surfaces = 0;
    for (int i = 0; i < 4; ++i) {
        bool background = gloam_is_background(depths[i]);
        if (background) d[i] = gloam_background_depth();
        if (!background) ++surfaces;
    }
    if (surfaces == 0) return vec4(0.0);
    ivec4 rank = ivec4(gloam_depth_rank(d, 0), gloam_depth_rank(d, 1), gloam_depth_rank(d, 2), gloam_depth_rank(d, 3));
    vec4 chosen = vec4(equal(rank, ivec4(surfaces == 1 ? 0 : 1)));
    float nearest = min(min(d.x, d.y), min(d.z, d.w));
    float farthest = max(max(d.x, d.y), max(d.z, d.w));
    bool together = surfaces == 4 && farthest - nearest <= tolerance;
    return together ? 0.5 * (chosen + vec4(equal(rank, ivec4(2)))) : chosen;
}

// normal of the pixel that stands for two (CS-F-normal): `(n_2 + n_3) / |n_2 + n_3|, n_2 if opposite` [Hoang and Low
// 2012 (MSSAO)].
// second, third: unit vectors, in the order of depth.
// Returns a unit vector; the second where the two are opposite (the mean is zero) or the third is not finite; the
// zero vector where the second is not. Error: 4e-7, growing as the two come nearer to opposite.
vec3 gloam_mssao_normal(vec3 second, vec3 third) {
    return gloam_safe_normalize(0.5 * (second + third), gloam_safe_normalize(second, vec3(0.0)));
}

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
