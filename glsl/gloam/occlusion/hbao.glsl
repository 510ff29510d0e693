// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_HBAO_GLSL
#define GLOAM_OCCLUSION_HBAO_GLSL

#include "gloam/geometry/safe_normalize.glsl"
#include "gloam/numeric/constants.glsl"
#include "gloam/numeric/inverse_trigonometry.glsl"
#include "gloam/numeric/sincos.glsl"
#include "gloam/shading/remap.glsl"

// Horizon-based ambient occlusion (Bavoil and Sainz 2008; CS-3.2 to 3.4): (1 / 2 pi) times the integral over
// directions of the image of W (sin h - sin t). h is the elevation of the horizon and t that of the tangent above the
// image plane. The cos of the integral is the Jacobian of solid angle, not n . w, so every direction counts the same.
// The result is therefore not the cosine-weighted occlusion (TSSAO-1): a pit whose walls rise by 45 degrees all around
// has 0.707 here and 0.5 there.

// slope of the tangent plane from derivatives of the position (CS-C-slope): `T.z / |T.xy|, T = x dP/du + y dP/dv`
// [Bavoil and Sainz 2008; Aalund and Baerentzen 2013, eqs 3.2 to 3.4].
// Slope of the tangent plane in a direction of the image, from the derivatives of the position: tan t = T.z / |T.xy|,
// T = x dP/du + y dP/dv.
// direction: (x, y), in units of u and v. dpdu, dpdv: view space, world units; each the smaller of the two one-sided
// differences.
// Returns a tangent in [-1e6, 1e6]; 0 where T is not finite or has no direction. Error: 6 ULP, and 8e-6 of the
// longest derivative over |T.xy|.
// No method or pass here calls it: it is there to be copied.
float gloam_tangent_slope(vec2 direction, vec3 dpdu, vec3 dpdv) {
    vec3 t = gloam_safe_normalize(direction.x * dpdu + direction.y * dpdv, vec3(0.0));
    float across = gloam_sqrt(dot(t.xy, t.xy));
    return across > 1e-6 ? clamp(t.z / across, -1e6, 1e6) : (t.z > 0.0 ? 1e6 : (t.z < 0.0 ? -1e6 : 0.0));
}

// sine of the angle with a tangent (CS-C-sine): `t / (1 + t^2)^(1/2), 1 from 1e6 on` [Bavoil and Sainz 2008; Aalund and
// Baerentzen 2013, eqs 3.2 to 3.4].
// tangent: any float; from 1e6 on the sine is 1.
// Returns a sine in [-1, 1]; 0 for NaN. Error: 2e-7.
float gloam_sine_of_tangent(float tangent) {
    float magnitude = abs(tangent);
    if (!(magnitude < 1e6)) return tangent > 0.0 ? 1.0 : (tangent < 0.0 ? -1.0 : 0.0);
    return clamp(tangent * inversesqrt(1.0 + magnitude * magnitude), -1.0, 1.0);
}

// elevation of the tangent plane above the image plane (CS-C-tangent): `atan(-(n.xy . direction) / n.z)` [Bavoil and
// Sainz 2008; Aalund and Baerentzen 2013, eqs 3.2 to 3.4].
// normal: n, unit, view space. direction: unit, in the image plane, y as in view space.
// Returns radians in [-pi / 2, pi / 2]; the nearer end for a normal that points away from the eye (n.z < 0), 0 for
// NaN. Error: 4e-7.
// No method or pass here calls it: it is there to be copied.
float gloam_tangent_elevation(vec3 normal, vec2 direction) {
    return clamp(gloam_atan2(-dot(normal.xy, direction), normal.z), -GLOAM_HALF_PI, GLOAM_HALF_PI);
}

// where the march along a direction starts (CS-C-start): `(sin(min(t + bias, pi / 2)), 0)` [Bavoil and Sainz 2008;
// Aalund and Baerentzen 2013, eqs 3.2 to 3.4].
// Where the march along a direction starts: (sin of the elevation from which on something blocks, 0 found so far).
// tangent: t, elevation of the tangent plane, radians. bias: radians above it, >= 0, 0.3 to 0.52: hides the facets of
// coarse meshes.
// Returns (sin(min(t + bias, pi / 2)), 0). (1, 0), which nothing exceeds, for NaN. Error: 4e-7.
// No method or pass here calls it: it is there to be copied.
vec2 gloam_hbao_start(float tangent, float bias) {
    float elevation = tangent + bias;
    return vec2(elevation < GLOAM_HALF_PI ? gloam_sincos(max(elevation, -GLOAM_HALF_PI)).y : 1.0, 0.0);
}

// direction from which on something blocks (CS-C-horizon): `(cos, sin) of min(t + bias, pi / 2), tan t = -(n.xy .
// direction) / n.z` [Bavoil and Sainz 2008; Aalund and Baerentzen 2013, eqs 3.2 to 3.4].
// The same from the normal, without an angle: the tangent plane's direction in the image's direction, turned up by the
// bias.
// normal: n, unit, view space. direction: unit, in the image plane, y as in view space. bias: (cos, sin) of the bias,
// which is in [0, pi / 2].
// Returns (cos, sin) of min(t + bias, pi / 2), t of gloam_tangent_elevation; t is pi / 2 for a normal across the plane
// of the direction and the view axis. Error: 4e-7 over the length of the normal's part in that plane.
vec2 gloam_hbao_horizon(vec3 normal, vec2 direction, vec2 bias) {
    vec2 plane = vec2(normal.z, -dot(normal.xy, direction));
    plane = plane.x > 0.0 ? plane * inversesqrt(dot(plane, plane)) : vec2(0.0, plane.y < 0.0 ? -1.0 : 1.0);
    vec2 raised = vec2(plane.x * bias.x - plane.y * bias.y, plane.y * bias.x + plane.x * bias.y);
    return raised.x > 0.0 || raised.y < 0.0 ? raised : vec2(0.0, 1.0);
}

// where the study's march along a direction starts (CS-C-start-slope): `(sin(atan(tan t + tan bias)), 0)` [Aalund and
// Baerentzen 2013, CS-C].
// Steep planes keep part of the view above them: at t = 75 degrees sin h_0 is 0.971 for a bias of 0.3, where t + bias
// is beyond the vertical and nothing could block.
// slope: tan t, of the tangent plane, any float. bias: radians, [0, 1.57079625).
// Returns (sin h_0, 0). (1, 0), which nothing exceeds, for a bias outside and NaN. Error: 5e-7.
vec2 gloam_hbao_start_slope(float slope, float bias) {
    if (!(bias >= 0.0 && bias < 1.570796251 && abs(slope) >= 0.0)) return vec2(1.0, 0.0);
    vec2 turned = gloam_sincos(bias);
    return vec2(gloam_sine_of_tangent(slope + turned.y / turned.x), 0.0);
}

// one step of HBAO's march (CS-C): `occ + (sin S - sin H) (1 - |v|^2 / R^2), then H = S, where S > H` [Bavoil and Sainz
// 2008; Aalund and Baerentzen 2013, eqs 3.2 to 3.4].
// One step of the march: if the sample rises above the horizon, what it adds, weighted by W = 1 - |v|^2 / R^2, and
// the new horizon.
// horizon: (sine of the horizon, occlusion so far) of gloam_hbao_start. offset: v = s - p, view space, world units.
// radius: R, world units.
// Returns the new pair; the occlusion lies in [0, 2] (1 where the tangent is level). Unchanged for v = 0, |v| >= R,
// for a sample not above the horizon, and for NaN. Error: 1e-6 for each step; one within 4 ULP of the radius or of
// the horizon may fall to either side.
// No method or pass here calls it: it is there to be copied.
vec2 gloam_hbao_step(vec2 horizon, vec3 offset, float radius) {
    vec3 direction = gloam_safe_normalize(offset, vec3(0.0));
    float x = dot(offset, direction) / radius;
    bool near =
        radius >= GLOAM_SMALLEST && radius <= GLOAM_LARGEST_DIVISOR && x < 1.0 && dot(direction, direction) > 0.5;
    if (!(near && direction.z > horizon.x)) return horizon;
    float sine = min(direction.z, 1.0);
    return vec2(sine, horizon.y + (sine - horizon.x) * (1.0 - x * x));
}

// how far apart the steps are, and how many (CS-C-steps): `(R / (N + extra), N), N = floor(min(N_s, R))` [Bavoil and
// Sainz 2008; NVIDIA's sample].
// radius: of the kernel's image, pixels. largest: upper bound of it, pixels: 0.1 of the image's smaller side keeps
// the march in the cache.
// steps: N_s, >= 1. extra: 0 for R / N_s (the last step lies on the radius, where it counts nothing), 1 for R / (N_s
// + 1) (NVIDIA).
// Returns (pixels between steps, number of steps): min(N_s, pixels) steps; (0, 0) for a radius below 1 pixel or NaN.
// Error: 1 ULP; a radius within 1 ULP of a whole number may give a step more or less.
// No method or pass here calls it: it is there to be copied.
vec2 gloam_hbao_step_size(float radius, float largest, float steps, float extra) {
    float reach = radius < largest ? radius : largest;
    if (!(reach >= 1.0 && reach <= GLOAM_LARGEST_DIVISOR && steps >= 1.0 && extra >= 0.0)) return vec2(0.0);
    float count = floor(steps < reach ? steps : reach);
    return vec2(reach / (count + extra), count);
}

// visibility from HBAO's mean over directions (CS-C-visibility): `1 - contrast occ / (1 - sin bias)` [NVIDIA's sample
// of Bavoil and Sainz 2008].
// The divisor compensates the bias.
// occlusion: mean of the y of gloam_hbao_step. bias: radians, as given to gloam_hbao_start. contrast: 1, or NVIDIA's
// 1.25.
// Returns visibility in [0, 1]; 1 for NaN and for a bias of 1.5 or more. Error: 5e-7 up to 0.8.
float gloam_hbao_visibility(float occlusion, float bias, float contrast) {
    float rest = 1.0 - gloam_sincos_turns(gloam_turns(bias)).y;
    if (!(abs(bias) < 1.5 && occlusion > 0.0 && contrast > 0.0)) return 1.0;
    float visibility = 1.0 - contrast * (occlusion / rest);
    return visibility > 0.0 ? visibility : (visibility <= 0.0 ? 0.0 : 1.0);
}

// NVIDIA's simplification of one tap of HBAO (CS-C-simplified): `sat(n . v / |v| - bias) sat(1 - |v|^2 / R^2) / (1 -
// bias)` [NVIDIA's sample gl_ssao].
// No horizon is
// kept: every tap counts.
// offset: v = s - p, view space, world units. normal: n, unit. radius: R, world units. bias: cosine, [0, 1), 0.1.
// Returns a contribution in [0, 1] for gloam_visibility_hbao_simplified; 0 for v = 0, |v| >= R, a bias outside [0,
// 1), NaN. Error: 1e-6.
// No method or pass here calls it: it is there to be copied.
float gloam_contribution_hbao_simplified(vec3 offset, vec3 normal, float radius, float bias) {
    vec3 direction = gloam_safe_normalize(offset, vec3(0.0));
    float x = dot(offset, direction) / radius;
    float above = dot(normal, direction) - bias;
    bool near = radius >= GLOAM_SMALLEST && radius <= GLOAM_LARGEST_DIVISOR && x < 1.0;
    if (!(near && above > 0.0 && bias >= 0.0 && bias < 1.0)) return 0.0;
    return min(above / (1.0 - bias), 1.0) * (1.0 - x * x);
}

// visibility from NVIDIA's simplification of HBAO (CS-C-simplified-visibility): `sat(1 - 2 mean)^power` [NVIDIA's
// sample gl_ssao].
// accumulated: (sum, count) of gloam_estimator_add. power: > 0, 1.5.
// Returns visibility in [0, 1]; 1 for a count below 1 and for NaN. Error: 2e-6.
// No method or pass here calls it: it is there to be copied.
float gloam_visibility_hbao_simplified(vec2 accumulated, float power) {
    if (!(accumulated.y >= 1.0 && accumulated.x > 0.0)) return 1.0;
    return gloam_remap(1.0 - 2.0 * (accumulated.x / accumulated.y), 0.0, 1.0, power);
}

#endif
