// SPDX-License-Identifier: MIT
#ifndef GLOAM_SHADING_AMBIENT_GLSL
#define GLOAM_SHADING_AMBIENT_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/sampling/unit_interval.glsl"

// ambient light that arrives (ISSAO-2): `I_a = I_0 (1 - A_0)` [ISSAO, eq 2, reconstructed].
// incident: I_0, any unit. occlusion: A_0 in [0, 1], taken to the nearer end outside, NaN to 0.
// Returns light in the unit of I_0. Error: 1.5 ULP.
vec3 gloam_ambient_light(vec3 incident, float occlusion) {
    return incident * (1.0 - gloam_unit_interval(occlusion));
}

// visibility with the light that bounces among blockers of the surface's colour (GTAO-bounce): `max(v, ((a v + b) v +
// c) v), v = 1 - A, a = 2.0404 p - 0.3324, b = 0.6417 - 4.7951 p, c = 2.7552 p + 0.6903` [Jimenez et al. 2016].
// Ambient occlusion alone is too dark where surfaces are bright, because blockers send light as well. The cubic was
// fitted by its authors to path-traced pictures. Multiply the ambient light by the result, in the place of 1 - A.
// occlusion: A in [0, 1], taken to the nearer end outside, NaN to 0. albedo: p, diffuse, linear, each in [0, 1],
// likewise.
// Returns a visibility for each channel, in [1 - A, 1]; 1 where A is 0. Error: 1.5e-6.
vec3 gloam_multi_bounce(float occlusion, vec3 albedo) {
    float v = 1.0 - gloam_unit_interval(occlusion);
    vec3 p = vec3(gloam_unit_interval(albedo.x), gloam_unit_interval(albedo.y), gloam_unit_interval(albedo.z));
    vec3 a = 2.0404 * p - 0.3324;
    vec3 b = 0.6417 - 4.7951 * p;
    vec3 c = 2.7552 * p + 0.6903;
    return clamp(((a * v + b) * v + c) * v, vec3(v), vec3(1.0));
}

// visibility remapped by offset, brightness and contrast (CS-REMAP): `clamp((b (v + a))^c, 0, 1)` [Aalund and
// Baerentzen 2013].
// ao: v, visibility in [0, 1], 1 = open. a: offset; 0.5 undoes the self-occlusion of methods that sample a whole
// sphere, else 0.
// b: brightness, 1. c: contrast, 1 (larger is darker).
// Returns visibility in [0, 1]. A base b (v + a) of 0 or less gives 0, but 1 for c < 0, where the power is infinite. c
// = 0 gives 1 whatever the base. NaN in any argument gives 1. c = 1 gives the base itself. Error: 2e-6 for |c| up to
// 16; by any device that keeps Vulkan's rules for pow(), 6e-6, most where the base is just below 1.
float gloam_remap(float ao, float a, float b, float c) {
    float base = b * (ao + a);
    if (!(base > 0.0)) return base <= 0.0 && c > 0.0 ? 0.0 : 1.0;
    // Where the power is 1 or more, pow() is not asked: its error would show most there.
    bool open = c > 0.0 ? base >= 1.0 : (c < 0.0 ? base <= 1.0 : true);
    if (open) return 1.0;
    return c == 1.0 ? base : clamp(pow(base, c), 0.0, 1.0);
}

// depth darkening (CS-R): `lambda min(G * D - D, 0)` [Luft, Colditz and Deussen 2006].
// The unsharp mask of the depth buffer, to be added to the colour. It darkens what lies behind a nearer object, next to
// its outline. It is not an occlusion: it was in use before there was one.
// depth: D, eye-linear, any unit (parts of the scene's depth are usual). blurred_depth: G * D, a wide Gaussian of the
// same image. strength: lambda, colour per unit of depth, >= 0.
// Returns a number <= 0, not below -FLT_MAX; 0 for background on either side, and for a strength not positive or NaN.
// Error: 2 ULP of lambda times the larger depth.
float gloam_depth_darkening(float depth, float blurred_depth, float strength) {
    if (gloam_is_background(depth) || gloam_is_background(blurred_depth) || !(strength > 0.0)) return 0.0;
    float difference = blurred_depth - depth;
    return difference < 0.0 ? max(strength * difference, -GLOAM_LARGEST) : 0.0;
}

#endif
