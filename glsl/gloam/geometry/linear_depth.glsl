// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_LINEAR_DEPTH_GLSL
#define GLOAM_GEOMETRY_LINEAR_DEPTH_GLSL

#include "gloam/geometry/background.glsl"

// A depth-buffer value b is the projection of the eye-linear depth d = -z. With the projection's elements P22 =
// P[2][2] and P32 = P[3][2] (column-major), clip z is P22 z + P32 and clip w is -z (perspective) or 1 (orthographic).
// Solving for d gives one formula for every choice of planes: standard, reversed, and infinite far plane differ only in
// the two elements. Where OpenGL's range [-1, 1] brings in a 2 b - 1, the 1 joins the element that it nearly cancels,
// which keeps that difference exact.

// quotient that is a depth, or the background (DEPTH-quotient): `a / b; +infinity unless positive and finite`
// [convention].
// numerator, denominator: any floats.
// Returns numerator / denominator, or the background depth +infinity where that is no depth: zero, subnormal or huge
// denominator (a far plane at infinity), result not positive, not finite, NaN. Error: at most 2.5 ulp.
float gloam_depth_quotient(float numerator, float denominator) {
    if (!(abs(denominator) >= GLOAM_SMALLEST && abs(denominator) <= GLOAM_LARGEST_DIVISOR))
        return gloam_background_depth();
    float depth = numerator / denominator;
    return gloam_is_background(depth) ? gloam_background_depth() : depth;
}

// eye-linear depth, perspective, depth range [0, 1] (DEPTH-perspective-vk): `d = P32 / (b + P22)` [the projection
// solved for depth].
// That of Vulkan and Direct3D: b = (P22 z + P32) / -z.
// b: depth-buffer value in [0, 1].
// p22, p32: projection elements: far / (near - far), far near / (near - far); reversed near / (far - near),
// far near / (far - near); reversed with infinite far plane 0, near.
// Returns d in world units; +infinity for the background: far plane at infinity, NaN, anything that gives no positive
// finite d. Error: at most 3 ulp.
float gloam_linear_depth_perspective_vk(float b, float p22, float p32) {
    return gloam_depth_quotient(p32, b + p22);
}

// eye-linear depth, perspective, depth range [-1, 1] (DEPTH-perspective-gl): `d = P32 / (2 b - 1 + P22)` [the
// projection solved for depth].
// OpenGL's: 2 b - 1 = (P22 z + P32) / -z.
// b: depth-buffer value in [0, 1] (window depth).
// p22, p32: projection elements: -(far + near) / (far - near), -2 far near / (far - near); both negated when reversed;
// infinite far plane -1, -2 near.
// Returns d as gloam_linear_depth_perspective_vk does. Error: at most 3.5 ulp, for |p22| >= 1 (every projection with
// 0 < near < far).
// No method or pass here calls it: it is OpenGL's projection; the passes read depth buffers of the range [0, 1].
float gloam_linear_depth_perspective_gl(float b, float p22, float p32) {
    // In this order: the sum of both constants would round away what the depth adds.
    GLOAM_PRECISE float denominator = p22 < 0.0 ? (2.0 * b - 1.0) + p22 : 2.0 * b + (p22 - 1.0);
    return gloam_depth_quotient(p32, denominator);
}

// eye-linear depth, orthographic, depth range [0, 1] (DEPTH-orthographic-vk): `d = (P32 - b) / P22` [the projection
// solved for depth].
// That of Vulkan and Direct3D: b = P22 z + P32.
// b: depth-buffer value in [0, 1].
// p22, p32: projection elements: 1 / (near - far), near / (near - far); reversed 1 / (far - near), far / (far - near).
// Returns d in world units; +infinity for the background: NaN, anything that gives no positive finite d.
// Error: at most 3 ulp.
float gloam_linear_depth_orthographic_vk(float b, float p22, float p32) {
    return gloam_depth_quotient(p32 - b, p22);
}

// eye-linear depth, orthographic, depth range [-1, 1] (DEPTH-orthographic-gl): `d = (P32 + 1 - 2 b) / P22` [the
// projection solved for depth].
// OpenGL's: 2 b - 1 = P22 z + P32.
// b: depth-buffer value in [0, 1] (window depth).
// p22, p32: projection elements: -2 / (far - near), -(far + near) / (far - near); both negated when reversed.
// Returns d in world units; +infinity for the background: NaN, anything that gives no positive finite d.
// Error: at most 4 ulp, for |p32| >= 1 (every projection with 0 <= near < far).
// No method or pass here calls it: it is OpenGL's projection; the passes read depth buffers of the range [0, 1].
float gloam_linear_depth_orthographic_gl(float b, float p22, float p32) {
    // In this order: the sum of both constants would round away what the depth adds.
    GLOAM_PRECISE float numerator = p32 < 0.0 ? (p32 + 1.0) - 2.0 * b : (p32 - 1.0) + 2.0 * (1.0 - b);
    return gloam_depth_quotient(numerator, p22);
}

#endif
