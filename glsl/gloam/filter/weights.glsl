// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_WEIGHTS_GLSL
#define GLOAM_FILTER_WEIGHTS_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/sampling/unit_interval.glsl"

// scale of distances for the Gaussian (TSSAO-10-g-scale): `s = sqrt(log2(e) / 2) / sigma` [TSSAO, eq 10].
// For gloam_gaussian_scaled, a factor that all neighbours of a pixel share. It is not squared, because the square could
// overflow or underflow.
// sigma: standard deviation, world units, >= 0.
// Returns the scale, in 1 / world units, from 2^-101 to 2^126 for all but three kinds of sigma: a zero, subnormal or
// negative one is read as 2^-126, of which no distance but 0 counts; above 2^100 (and for infinity) 0, with which
// every finite distance counts wholly; for NaN infinity, with which nothing counts. Error: 2.5 ULP.
float gloam_gaussian_scale(float sigma) {
    if (gloam_is_nan(sigma)) return uintBitsToFloat(0x7F800000u);
    float scale = 0.8493218003 / max(sigma, GLOAM_SMALLEST);
    return sigma <= 1.2676506e30 ? scale : 0.0;
}

// weight of a neighbour by the scale of the Gaussian (TSSAO-10-g-scaled): `g = 2^-(d s)^2` [TSSAO, eq 10].
// It is exp(-d^2 / (2 sigma^2)), by its distance in the world.
// squared_distance: d^2, world units squared, of which the sign does not count. scale: of gloam_gaussian_scale, 1 /
// world units.
// Returns a weight in [0, 1], not below 1e-30 unless 0. 0 for infinity or NaN in either, else 1 for distance 0 or scale
// 0. Error: 3e-7; 5e-7 by any device that keeps Vulkan's rules for exp2(), 3 + 2 x ULP of a weight of 2^-x: the
// smallest weights hold to 3e-5 of themselves.
float gloam_gaussian_scaled(float squared_distance, float scale) {
    // In this order: the square of the scale may be beyond the largest float, or subnormal.
    GLOAM_PRECISE float x = abs(squared_distance) * scale * scale;
    float weight = min(exp2(-x), 1.0);
    return x <= 99.5 ? weight : 0.0;
}

// weight of a neighbour by its distance in the world (TSSAO-10-g): `g = exp(-d^2 / (2 sigma^2))` [TSSAO, eq 10].
// Depth edges need no further term.
// squared_distance: d^2, world units squared, of which the sign does not count. sigma: world units, >= 0.
// Returns a weight in [0, 1], not below 1e-30 unless 0. For sigma zero, subnormal or negative: 1 at distance 0, else
// 0. An infinite distance gives 0, an infinite sigma 1 at every finite one, NaN in either 0. Error: 3e-7; 1e-6 by any
// device that keeps Vulkan's rules for exp2() and division.
float gloam_gaussian(float squared_distance, float sigma) {
    return gloam_gaussian_scaled(squared_distance, gloam_gaussian_scale(sigma));
}

// width of the filter in the world (TSSAO-10-sigma): `sigma = sigma_px 2 d tan(fov_y / 2) / H` [derived: world size of
// a pixel].
// depth: eye-linear, world units. tan_half_fovy: tangent of half the vertical field of view. height: H, pixels.
// sigma_pixels: about a quarter of the filter's width (1.25 for 5 x 5). Orthographic: pass depth 1 and half the
// height of the view.
// Returns sigma in world units, in [0, FLT_MAX]; 0 for background depth, for any other argument that is not positive or
// NaN, and where infinite ones leave the quotient unknown. Error: 4 ULP.
float gloam_filter_sigma(float depth, float tan_half_fovy, float height, float sigma_pixels) {
    if (gloam_is_background(depth) || !(tan_half_fovy > 0.0 && height >= GLOAM_SMALLEST && sigma_pixels > 0.0))
        return 0.0;
    float sigma = 2.0 * tan_half_fovy * depth * (sigma_pixels / height);
    return sigma <= GLOAM_LARGEST ? sigma : (sigma > 0.0 ? GLOAM_LARGEST : 0.0);
}

// A weighted mean of occlusion values being formed. The range of the values is kept as well: the quotient of two
// rounded sums may leave it, and with it a constant image would change, and a lone neighbour would not give its own
// value.
struct GloamWeightedMean {
    float sum;     // of weight times value
    float weight;  // sum of weights (K of TSSAO-10)
    float low;     // smallest value with a weight
    float high;    // largest value with a weight
};

// weighted mean of nothing (TSSAO-10-empty): `(0, 0)` [TSSAO, the quotient of eq 10].
// The mean of nothing: no weight, an empty range. Error: none.
GloamWeightedMean gloam_weighted_mean_empty() {
    return GloamWeightedMean(0.0, 0.0, 1.0, 0.0);
}

// one more value in a weighted mean (TSSAO-10-add): `(sum + w AO, K + w)` [TSSAO, the quotient of eq 10].
// mean: what was added so far. value: occlusion in [0, 1]. weight: >= 0.
// Returns the mean with the value; unchanged for a value outside [0, 1] or NaN and for a weight that is not positive
// and finite. Error: 1.5 ULP for each addition.
GloamWeightedMean gloam_weighted_mean_add(GloamWeightedMean mean, float value, float weight) {
    if (!(value >= 0.0 && value <= 1.0 && weight > 0.0 && weight <= GLOAM_LARGEST)) return mean;
    return GloamWeightedMean(mean.sum + weight * value, mean.weight + weight, min(mean.low, value),
                             max(mean.high, value));
}

// weighted mean, or what stands in for it (TSSAO-10-mean): `sum / K, the fallback for K < 1e-8` [TSSAO,
// the quotient of eq 10].
// mean: of weights below 1e30. fallback: what to return where the weights sum to less than 1e-8; taken to the nearer
// end outside [0, 1], NaN to 0.
// Returns the mean, between the smallest and the largest value, both included. Error: 2.5 ULP of the quotient.
float gloam_weighted_mean_value(GloamWeightedMean mean, float fallback) {
    if (mean.weight >= 1e-8) return clamp(mean.sum / mean.weight, mean.low, mean.high);
    return fallback > 0.0 ? (fallback < 1.0 ? fallback : 1.0) : 0.0;
}

// factor on the filter's support (TSSAO-11): `s = max(c - conv, 0) / c` [TSSAO, eq 11].
// Pixels that have converged are not filtered.
// convergence: conv; below 0 it is read as 0, NaN gives 1. c_adaptive: c, 0.2: the convergence from which nothing is
// filtered.
// Returns a factor in [0, 1]: 1 for no convergence, falling linearly to 0 at c. 0 for c below 1e-30, negative or NaN;
// 1 for c above 2^126 and conv below it. Error: 3 ULP.
float gloam_shrink(float convergence, float c_adaptive) {
    if (!(c_adaptive >= 1e-30) || convergence >= c_adaptive) return 0.0;
    if (!(convergence > 0.0) || c_adaptive > GLOAM_LARGEST_DIVISOR) return 1.0;
    return min((c_adaptive - convergence) / c_adaptive, 1.0);
}

// how much of a pixel lies in the filter's window (TSSAO-11-window): `clamp(reach + 1 - |i|, 0, 1)` [derived: overlap
// of a pixel with a window of half width reach + 1/2].
// The window reaches from the middle of the centre pixel to `reach` pixels beyond it and half a pixel more on either
// side; a pixel counts by the part covered. No pixel counts twice, whatever the shrink factor, and a reach of n gives n
// whole pixels on each side. The result changes smoothly as the window shrinks. Fewer taps spread over rounded
// positions would do neither.
// offset: distance from the centre pixel, 1 or more. reach: half width of the window in pixels, >= 0.
// Returns clamp(reach - (offset - 1), 0, 1); 0 for NaN. Error: none for offsets up to 2^24.
float gloam_window_coverage(int offset, float reach) {
    return gloam_unit_interval(reach - float(offset - 1));
}

// weight of a neighbour that has converged (TSSAO-10-weight): `coverage g(|p - x|) conv(x)` [TSSAO, eq 10].
// offset: p - x or x - p, world units. coverage: part of the neighbour in the window, [0, 1]; below 1e-30 it may count
// as 0. scale: of gloam_gaussian_scale, 1 / world units. convergence: conv(x), [0, 1].
// Returns a weight in [0, 1]; 0 for an infinite offset. Error: 5e-7.
float gloam_convergence_weight(vec3 offset, float coverage, float scale, float convergence) {
    return coverage * gloam_gaussian_scaled(dot(offset, offset), scale) * convergence;
}

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

// weight of a tap of SAO's blur (CS-Q-blur): `(0.3 + g_r) max(0, 1 - slope |dkey|)` [McGuire, Mara and Luebke 2012
// (Scalable Ambient Obscurance)].
// Along one axis, g_0 at the centre; the taps are two pixels apart. g is a Gaussian of standard deviation 3 taps,
// normalised over its nine taps (the reference shader says 2).
// tap: r, number of the tap, -4 to 4. key_difference: of the tap's depth key to the centre's. slope: per unit of key,
// >= 0: 2000 times the edge sharpness; negative counts as 0.
// Returns a weight in [0, 0.445]; 0 for a tap outside its range, and off the centre where slope |key difference| is
// NaN. Error: 2e-7, and that of slope |key difference| times 0.445.
float gloam_sao_blur_weight(int tap, float key_difference, float slope) {
    if (tap == 0) return 0.153170;
    if (tap > 4 || tap < -4) return 0.0;
    int r = abs(tap);
    float g = r == 1 ? 0.144893 : (r == 2 ? 0.122649 : (r == 3 ? 0.092902 : 0.062970));
    float difference = abs(key_difference);
    float fall = difference == 0.0 || slope <= 0.0 ? 0.0 : difference * slope;
    return fall < 1.0 ? (0.3 + g) * (1.0 - fall) : 0.0;
}

#endif
