// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_SAO_GLSL
#define GLOAM_OCCLUSION_SAO_GLSL

#include "gloam/numeric/constants.glsl"
#include "gloam/numeric/square_root.glsl"
#include "gloam/occlusion/visibility.glsl"
#include "gloam/shading/remap.glsl"

// Scalable Ambient Obscurance (McGuire, Mara and Luebke 2012): the contribution of the surface point under a tap, and
// the visibility from the sum of contributions. v = s - p. All contributions except the last are in 1 / world units,
// and are summed by gloam_estimator_add for gloam_visibility_sao. The reference shader states some of them for a radius
// of one metre; these are divided by a power of the radius to get this unit.

// the part of the falloffs inside the radius (CS-Q-window): `max(1 - v^2 / r^2, 0)` [McGuire, Mara and Luebke 2012
// (Scalable Ambient Obscurance)].
// The part 1 - v^2 / r^2 of the falloffs, without a square root.
// squared_distance: v^2, world units squared, >= 0. radius: r, world units, in [8.9e-16, 9.2e18].
// Returns a weight in [0, 1]; 0 at and beyond the radius, for a radius outside its range and for NaN. Error: 3e-7.
// No method or pass here calls it: it is there to be copied.
float gloam_sao_window(float squared_distance, float radius) {
    float r2 = radius * radius;
    // 2^-100: a difference below 2^-126 may be flushed to 0, and is then less than the error.
    bool inside = squared_distance >= 0.0 && squared_distance < r2 && r2 >= 7.888609052e-31 &&
                  r2 <= GLOAM_LARGEST_DIVISOR && radius > 0.0;
    return inside ? min((r2 - squared_distance) / r2, 1.0) : 0.0;
}

// height over the tangent plane, less the bias (CS-Q-height): `max(v . n - bias, 0)` [McGuire, Mara and Luebke 2012
// (Scalable Ambient Obscurance)].
// offset: v, world units. normal: n, unit vector, same space. bias: world units, 0.01 m.
// Returns a height >= 0 in world units; 0 where it is not finite. Error: 5e-7 for |v| up to 3.
// No method or pass here calls it: it is there to be copied.
float gloam_sao_height(vec3 offset, vec3 normal, float bias) {
    float height = dot(offset, normal) - bias;
    return height > 0.0 && height <= GLOAM_LARGEST ? height : 0.0;
}

// height over squared distance (CS-Q-quotient): `h / (v^2 + epsilon)` [McGuire, Mara and Luebke 2012 (Scalable Ambient
// Obscurance)].
// height: h, world units, >= 0. squared_distance: v^2, world units squared, >= 0. epsilon: world units squared, > 0:
// 0.01 m^2 (a large one keeps cracks from turning black).
// Returns 1 / world units, at most 1 / (2 sqrt(epsilon)) for h <= |v|; 0 where v^2 + epsilon is not in [2^-126,
// 2^126], and for h NaN.
// Error: 2 ULP; 3.5 by any device that keeps Vulkan's rules for division.
// No method or pass here calls it: it is there to be copied.
float gloam_sao_quotient(float height, float squared_distance, float epsilon) {
    float denominator = squared_distance + epsilon;
    bool divides = denominator >= GLOAM_SMALLEST && denominator <= GLOAM_LARGEST_DIVISOR;
    return divides && height > 0.0 ? height / denominator : 0.0;
}

// contribution of a surface point (CS-Q): `(1 - v^2 / r^2)^3 max(v . n - bias, 0) / (v^2 + epsilon), |v| < r` [McGuire,
// Mara and Luebke 2012 (Scalable Ambient Obscurance)].
// Contribution of SAO as recommended: (1 - v^2 / r^2)^3 max(v . n - bias, 0) / (v^2 + epsilon), for |v| < r.
// offset: v, world units. normal: n, unit vector, same space. radius: r, world units, in [8.9e-16, 9.2e18]: 1 m.
// bias: world units, 0.01 m. epsilon: world units squared, > 0: 0.01 m^2.
// Returns a contribution >= 0 in 1 / world units; 0 for v = 0, at and beyond the radius, below the plane raised by
// the bias, and for what is not finite. Error: 3e-6 for an epsilon of 0.01 or more.
// No method or pass here calls it: it is there to be copied.
float gloam_contribution_sao(vec3 offset, vec3 normal, float radius, float bias, float epsilon) {
    float vv = dot(offset, offset);
    float window = gloam_sao_window(vv, radius);
    if (!(window > 0.0)) return 0.0;
    return window * window * window * gloam_sao_quotient(gloam_sao_height(offset, normal, bias), vv, epsilon);
}

// contribution without falloff, as in the paper (CS-Q-A): `0.6 max(v . n - bias, 0) / (v^2 + epsilon), |v| < r`
// [McGuire, Mara and Luebke 2012 (Scalable Ambient Obscurance)].
// offset, normal, radius, bias, epsilon: as for gloam_contribution_sao.
// Returns a contribution >= 0 in 1 / world units; 0 as there. Error: 1.2e-6 for an epsilon of 0.01 or more, but for
// points within rounding of the radius.
// No method or pass here calls it: it is there to be copied.
float gloam_contribution_sao_paper(vec3 offset, vec3 normal, float radius, float bias, float epsilon) {
    float vv = dot(offset, offset);
    bool inside = gloam_sao_window(vv, radius) > 0.0;
    return inside ? 0.6 * gloam_sao_quotient(gloam_sao_height(offset, normal, bias), vv, epsilon) : 0.0;
}

// contribution of medium contrast (CS-Q-C): `4 (1 - v^2 / r^2) max(v . n - bias, 0) / r^2, |v| < r` [McGuire, Mara and
// Luebke 2012 (Scalable Ambient Obscurance)].
// offset, normal, radius, bias: as for gloam_contribution_sao.
// Returns a contribution >= 0 in 1 / world units, at most 1.54 / r; 0 as there. Error: 1.4e-6 for radii of 0.5 or more.
// No method or pass here calls it: it is there to be copied.
float gloam_contribution_sao_medium(vec3 offset, vec3 normal, float radius, float bias) {
    float window = gloam_sao_window(dot(offset, offset), radius);
    return window > 0.0 ? 4.0 * window * gloam_sao_height(offset, normal, bias) / (radius * radius) : 0.0;
}

// contribution of low contrast (CS-Q-D): `2 max(v . n - bias, 0) / r^2, |v| < r` [McGuire, Mara and Luebke 2012
// (Scalable Ambient Obscurance)].
// offset, normal, radius, bias: as for gloam_contribution_sao.
// Returns a contribution >= 0 in 1 / world units, at most 2 / r; 0 as there. Error: 1e-6 for radii of 0.5 or more,
// but for points within rounding of the radius.
// No method or pass here calls it: it is there to be copied.
float gloam_contribution_sao_low(vec3 offset, vec3 normal, float radius, float bias) {
    bool inside = gloam_sao_window(dot(offset, offset), radius) > 0.0;
    return inside ? 2.0 * gloam_sao_height(offset, normal, bias) / (radius * radius) : 0.0;
}

// high-quality contribution of the deep G-buffer (CS-Q-deep): `(1 - v^2 / r^2) max(v . n - bias, 0) / sqrt(epsilon +
// v^2), |v| < r` [Mara, McGuire, Nowrouzezahrai and Luebke 2016 (deep G-buffers)].
// offset, normal, radius, bias, epsilon: as for gloam_contribution_sao.
// Returns a contribution in [0, 1], for gloam_visibility_deep; 0 as there. Error: 5e-7.
// No method or pass here calls it: it is there to be copied.
float gloam_contribution_deep(vec3 offset, vec3 normal, float radius, float bias, float epsilon) {
    float vv = dot(offset, offset);
    float window = gloam_sao_window(vv, radius);
    float reach = gloam_sqrt(vv + epsilon);
    bool divides = window > 0.0 && reach > 0.0 && reach <= GLOAM_LARGEST_DIVISOR;
    return divides ? window * min(gloam_sao_height(offset, normal, bias) / reach, 1.0) : 0.0;
}

// visibility from the sum of contributions (CS-Q-visibility): `max(0, 1 - 5 sigma sum / n)` [McGuire, Mara and Luebke
// 2012 (Scalable Ambient Obscurance)].
// accumulated: (sum, count) of gloam_estimator_add, contributions in 1 / world units. sigma: intensity, world units.
// Returns visibility in [0, 1]; 1 for a count outside [1, 2^24], for a negative sigma, and for NaN. Error: 3e-7.
// No method or pass here calls it: it is there to be copied.
float gloam_visibility_sao(vec2 accumulated, float sigma) {
    if (!(accumulated.y >= 1.0 && accumulated.y <= 16777216.0)) return 1.0;
    return gloam_visibility(5.0 * sigma * (accumulated.x / accumulated.y));
}

// visibility from the sum of high-quality contributions (CS-Q-deep-visibility): `max(0, 1 - sqrt(3 sum / n))^power`
// [Mara, McGuire, Nowrouzezahrai and Luebke 2016 (deep G-buffers)].
// accumulated: (sum, count) of gloam_contribution_deep. power: contrast, 1.
// Returns visibility in [0, 1]; 1 for a count outside [1, 2^24], for a power of 0, and for NaN. Error: 1e-6 for a
// power of 1 or more.
// No method or pass here calls it: it is there to be copied.
float gloam_visibility_deep(vec2 accumulated, float power) {
    if (!(accumulated.y >= 1.0 && accumulated.y <= 16777216.0)) return 1.0;
    return gloam_remap(gloam_visibility(gloam_sqrt(3.0 * (accumulated.x / accumulated.y))), 0.0, 1.0, power);
}

#endif
