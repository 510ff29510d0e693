// SPDX-License-Identifier: MIT
#ifndef GLOAM_SHADING_MULTI_BOUNCE_GLSL
#define GLOAM_SHADING_MULTI_BOUNCE_GLSL

#include "gloam/sampling/unit_interval.glsl"

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

#endif
