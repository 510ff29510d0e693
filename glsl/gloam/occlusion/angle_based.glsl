// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_ANGLE_BASED_GLSL
#define GLOAM_OCCLUSION_ANGLE_BASED_GLSL

#include "gloam/geometry/vector.glsl"
#include "gloam/shading/ambient.glsl"

// Angle-based occlusion of opposite pairs of samples, as in Unreal Engine 4 (Mittring 2012; CS-P): the angle between
// both samples of a pair, over pi, is what is open. Neither cosine-weighted nor uniform: a groove of 45 degrees is
// 0.829 open (0.854 and 0.75 would be).

// cosine of a sample's angle to the view vector, no lower than the tangent plane (CS-P-lifted): `view . s, s lifted to
// s - (s . n) n where s . n < 0` [Mittring 2012; Aalund and Baerentzen 2013].
// offset: v = s - p, view space, world units. normal: n, unit. view: from the point to the eye, unit.
// Returns a cosine in [-1, 1]; 0 (a sample in the image plane) for a zero or non-finite offset, one along -n within
// 1e-3, and NaN. Error: 5e-7; 1e-6 over the distance of v / |v| from -n below the tangent plane.
float gloam_lifted_cosine(vec3 offset, vec3 normal, vec3 view) {
    vec3 direction = gloam_safe_normalize(offset, vec3(0.0));
    float above = dot(direction, normal);
    vec3 lifted = above < 0.0 ? direction - above * normal : direction;
    float squared = dot(lifted, lifted);
    if (!(squared > 1e-6)) return 0.0;
    float cosine = dot(view, lifted) * inversesqrt(squared);
    return abs(cosine) <= 1.0 ? cosine : (cosine > 1.0 ? 1.0 : (cosine < -1.0 ? -1.0 : 0.0));
}

// whether a sample may belong to the same object (CS-P-near): `z_s - z_p <= T` [Mittring 2012; Aalund and Baerentzen
// 2013].
// offset: s - p, view space, world units. range: T, world units.
// Returns false for NaN. Error: none.
bool gloam_sample_near(vec3 offset, float range) {
    return offset.z <= range;
}

// cosines and weight of a pair of opposite samples (CS-P-pair): `(c_1, c_2, w), an invalid one max(-view . s_j, 0)`
// [Mittring 2012; Aalund and Baerentzen 2013].
// An invalid sample is replaced by the mirror image of its partner; the published shader mirrors the invalid sample
// itself.
// first, second: s_1 - p, s_2 - p, view space, world units. normal: n, unit. view: to the eye, unit. range: T, see
// gloam_sample_near.
// Returns (cos of the first, cos of the second, weight): weight 1, 1/2 for one invalid sample, 0 (and cosines 0) for
// two. Error: as gloam_lifted_cosine.
vec3 gloam_angle_pair(vec3 first, vec3 second, vec3 normal, vec3 view, float range) {
    bool a = gloam_sample_near(first, range);
    bool b = gloam_sample_near(second, range);
    if (a && b) return vec3(gloam_lifted_cosine(first, normal, view), gloam_lifted_cosine(second, normal, view), 1.0);
    if (!a && !b) return vec3(0.0);
    float valid = gloam_lifted_cosine(a ? first : second, normal, view);
    float mirrored = gloam_unit_interval(-dot(view, gloam_safe_normalize(a ? first : second, vec3(0.0))));
    return a ? vec3(valid, mirrored, 0.5) : vec3(mirrored, valid, 0.5);
}

// a step along one side in the engine's later shader (CS-P-unreal): `min(scale (v . n) / (v . v), 1) if v . n > bias,
// else 0` [Unreal Engine 4, as ported].
// The largest of a side's steps is its occlusion.
// offset: v = s - p, view space, world units. normal: n, unit. bias: world units, >= 0. scale: world units, 0.8 in the
// engine.
// Returns a contribution in [0, 1]; 0 for what is no higher than the bias over the tangent plane. Error: 5e-7 of
// scale / |v|.
float gloam_contribution_unreal(vec3 offset, vec3 normal, float bias, float scale) {
    float above = dot(offset, normal);
    float counted = scale * (above / dot(offset, offset));
    return above > bias ? min(counted, 1.0) : 0.0;
}

// what a side leaves open in the engine's later shader (CS-P-unreal-side): `(1 - occ)^2` [Unreal Engine 4, as ported].
// To be averaged over the sides.
// occlusion: of the side, taken into [0, 1], NaN to 0.
// Returns visibility in [0, 1]. Error: 2 ULP.
float gloam_unreal_side(float occlusion) {
    float open = 1.0 - gloam_unit_interval(occlusion);
    return open * open;
}

// visibility in the engine's later shader (CS-P-unreal-visibility): `1 - (1 - AO^power) intensity` [Unreal Engine 4, as
// ported].
// ao: mean of gloam_unreal_side, [0, 1]. power: > 0. intensity: [0, 1].
// Returns visibility in [0, 1]; 1 for NaN. Error: 1e-6, and that of gloam_remap.
float gloam_unreal_visibility(float ao, float power, float intensity) {
    float visibility = 1.0 - (1.0 - gloam_remap(ao, 0.0, 1.0, power)) * intensity;
    return visibility < 1.0 ? (visibility > 0.0 ? visibility : 0.0) : 1.0;
}

#endif
