// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_BILATERAL_WEIGHT_GLSL
#define GLOAM_FILTER_BILATERAL_WEIGHT_GLSL

#include "gloam/filter/gaussian.glsl"

// weight of a neighbour by distance and depth (ISSAO-7-weight): `exp(-(|xi - x| / sigma_d)^2 / 2) exp(-((dp(xi) -
// dp(x)) / sigma_r)^2 / 2)` [ISSAO, eq 7; Tomasi and Manduchi 1998].
// offset: xi - x, pixels. depth_difference: dp(xi) - dp(x), world units. sigma_d: pixels, about 2. sigma_r: world
// units.
// Returns a weight in [0, 1], not below 1e-30 unless 0; for a sigma zero, negative or subnormal its factor is 1 at
// difference 0, else 0. 0 for NaN. Differences below 1e-19 count as 0, of depth above 1e19 as infinite. Error: 4e-7.
float gloam_bilateral_weight(vec2 offset, float depth_difference, float sigma_d, float sigma_r) {
    float weight =
        gloam_gaussian(dot(offset, offset), sigma_d) * gloam_gaussian(depth_difference * depth_difference, sigma_r);
    return weight >= 1e-30 ? weight : 0.0;
}

#endif
