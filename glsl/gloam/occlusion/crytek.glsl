// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_CRYTEK_GLSL
#define GLOAM_OCCLUSION_CRYTEK_GLSL

#include "gloam/occlusion/gather_kernel.glsl"

// Crytek's screen-space ambient occlusion (Mittring 2007; CS-3.1): points of a whole ball around the surface against
// the depth buffer, without falloff. On a plane half of the ball lies in the ground, so the mean is 1/2 (1/4 open in
// an inner corner, 3/4 on an edge): the offset 0.5 of gloam_remap undoes it.

// Crytek's contribution of a sample point (CS-A): `1 - V', V' = 1 if s_d > s_z, else 0` [Mittring 2007; Aalund and
// Baerentzen 2013, eq 3.1].
// sample_depth: s_z, eye-linear, world units; the sample is p + R s with s in the unit ball, in view space.
// buffer_depth: s_d at its pixel.
// Returns occlusion, 0 or 1: 1 where buffer_depth <= sample_depth, equality included: a bias keeps a plane seen
// head-on from that. 0 for background in the buffer, as gloam_tap_sees reads it, and for NaN. Error: none.
float gloam_contribution_crytek(float sample_depth, float buffer_depth) {
    return gloam_tap_sees(buffer_depth) && buffer_depth <= sample_depth ? 1.0 : 0.0;
}

// Crytek's contribution by the values of a depth buffer (CS-A-buffer): `1 - V', V' = 1 if s_d > s_z, else 0` [Mittring
// 2007; Aalund and Baerentzen 2013, eq 3.1].
// As published: 0 at the near plane, 1 at the far plane (standard Z; pass 1 - b for reversed Z).
// sample_value: third component of gloam_crytek_sample. buffer_value: b at its pixel, in [0, 1].
// Returns occlusion, 0 or 1: 0 for b >= 1, which is background, and for NaN. Error: none.
// No method or pass here calls it: it is the test of the comparative study, in buffer space.
float gloam_contribution_crytek_buffer(float sample_value, float buffer_value) {
    return buffer_value < 1.0 && buffer_value <= sample_value ? 1.0 : 0.0;
}

// Crytek's sample point in the space of the depth buffer (CS-A-sample): `(uv, b) + R (s.xy a, s.z b c), a = 1 / d, c =
// (100 / z_far) a` [Aalund and Baerentzen 2013, published shader].
// The scaling of z is a constant that suits one scene, not a projection: p + R s in view space, projected, is exact.
// uv: of the pixel, texture coordinates. buffer_value: b, in [0, 1]. s: point of the unit ball. radius: R. depth: d,
// eye-linear, world units; taken into [1e-30, 2^126]. z_far: far plane, world units, > 0.
// Returns (u, v, b) of the sample; (uv, b) itself for background depth, for z_far outside [1e-30, 2^126], and where the
// sample would not be finite. Error: 4 ULP of the largest of the value and its change.
// No method or pass here calls it: it is the projection of the comparative study; the method projects in view space.
vec3 gloam_crytek_sample(vec2 uv, float buffer_value, vec3 s, float radius, float depth, float z_far) {
    vec3 center = vec3(uv, buffer_value);
    if (gloam_is_background(depth) || !(z_far >= 1e-30 && z_far <= GLOAM_LARGEST_DIVISOR)) return center;
    float a = radius / clamp(depth, 1e-30, GLOAM_LARGEST_DIVISOR);
    vec3 point = center + a * s * vec3(1.0, 1.0, buffer_value * (100.0 / z_far));
    return gloam_is_finite3(point) ? point : center;
}

// contribution of a sample point, after Filion and McNaughton (CS-B): `1 - clamp((D - R) / D, 0, 1), D = d_s - d_b > 0`
// [Filion and McNaughton 2008].
// Contribution of a point of the half ball: D is how far the surface at the sample's pixel lies in front of it. Blocked
// down to R in front, opening again as R / D beyond. The simple variant that is open beyond R is gloam_sample_blocked.
// sample_depth, buffer_depth: eye-linear, world units. radius: R, world units, > 0.
// Returns occlusion in [0, 1]: 0 for D <= 0 (where the printed quotient divides by 0), 1 for 0 < D <= R, R / D
// beyond. 0 for background in the buffer, as gloam_tap_sees reads it, and for NaN. Error: 2e-7, and what an
// ULP of each depth changes.
float gloam_contribution_filion(float sample_depth, float buffer_depth, float radius) {
    float in_front = sample_depth - buffer_depth;
    float opened = in_front > radius ? radius / in_front : 1.0;
    return gloam_tap_sees(buffer_depth) && in_front > 0.0 ? opened : 0.0;
}

#endif
