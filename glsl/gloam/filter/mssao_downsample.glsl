// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_MSSAO_DOWNSAMPLE_GLSL
#define GLOAM_FILTER_MSSAO_DOWNSAMPLE_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/geometry/safe_normalize.glsl"

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

#endif
