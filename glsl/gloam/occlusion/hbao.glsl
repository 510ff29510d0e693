// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_HBAO_GLSL
#define GLOAM_OCCLUSION_HBAO_GLSL

#include "gloam/geometry/vector.glsl"
#include "gloam/numeric/arithmetic.glsl"
#include "gloam/numeric/sincos.glsl"

// Horizon-based ambient occlusion (Bavoil and Sainz 2008; CS-3.2 to 3.4): (1 / 2 pi) times the integral over
// directions of the image of W (sin h - sin t). h is the elevation of the horizon and t that of the tangent above the
// image plane. The cos of the integral is the Jacobian of solid angle, not n . w, so every direction counts the same.
// The result is therefore not the cosine-weighted occlusion (TSSAO-1): a pit whose walls rise by 45 degrees all around
// has 0.707 here and 0.5 there.

// slope of the tangent plane in a direction of the image (CS-C-slope): `tan t = -(n.xy . direction) / n.z` [Bavoil and
// Sainz 2008; Aalund and Baerentzen 2013, eqs 3.2 to 3.4].
// (Printed from the derivatives of the position: gloam_tangent_slope_of_derivatives.)
// normal: n, unit, view space. direction: unit, in the image plane, y as in view space.
// Returns a tangent in [-1e6, 1e6]; where n.z is below 1e-6, it is read as 1e-6. Error: 1e-7 over n.z, and 3 ULP.
float gloam_tangent_slope(vec3 normal, vec2 direction) {
    return clamp(-dot(normal.xy, direction) / max(normal.z, 1e-6), -1e6, 1e6);
}

// slope of the tangent plane from derivatives of the position (CS-C-derivatives): `T.z / |T.xy|, T = x dP/du + y dP/dv`
// [Bavoil and Sainz 2008; Aalund and Baerentzen 2013, eqs 3.2 to 3.4].
// direction: (x, y), in units of u and v. dpdu, dpdv: view space, world units; each the smaller of the two one-sided
// differences.
// Returns a tangent in [-1e6, 1e6]; 0 where T is not finite or has no direction. Error: 6 ULP, and 8e-6 of the
// longest derivative over |T.xy|.
// No method or pass here calls it: it is the tangent of the comparative study, as printed; the methods have normals.
float gloam_tangent_slope_of_derivatives(vec2 direction, vec3 dpdu, vec3 dpdv) {
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

// direction from which on something blocks (CS-C-horizon): `(cos, sin) of min(t + bias, pi / 2), tan t = -(n.xy .
// direction) / n.z` [Bavoil and Sainz 2008; Aalund and Baerentzen 2013, eqs 3.2 to 3.4].
// Without an angle: the tangent plane's direction in the image's direction, turned up by the bias, which hides the
// facets of coarse meshes.
// normal: n, unit, view space. direction: unit, in the image plane, y as in view space. bias: (cos, sin) of the bias,
// which is in [0, pi / 2].
// Returns (cos, sin) of min(t + bias, pi / 2), t = atan of gloam_tangent_slope; t is pi / 2 for a normal across the
// plane of the direction and the view axis. Error: 4e-7 over the length of the normal's part in that plane.
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
    if (!(bias >= 0.0 && bias < 1.570796251) || gloam_is_nan(slope)) return vec2(1.0, 0.0);
    vec2 turned = gloam_sincos(bias);
    return vec2(gloam_sine_of_tangent(slope + turned.y / turned.x), 0.0);
}

// one step of HBAO's march (CS-C): `occ + (sin S - sin H) (1 - |v|^2 / R^2), then H = S, where S > H` [Bavoil and Sainz
// 2008; Aalund and Baerentzen 2013, eqs 3.2 to 3.4].
// march: (sine of the horizon, occlusion so far): at first of gloam_hbao_horizon or gloam_hbao_start_slope, and 0.
// rise: part of v = s - p along the view axis, world units. squared: |v|^2. radius: R, world units, > 0.
// Returns the new pair; the occlusion of a side lies in [0, 2] (1 where the tangent is level). Unchanged for |v| > R,
// for a sample not above the horizon, and for NaN. Error: 9e-7 for each step; one within 4 ULP of the radius or of the
// horizon may fall to either side.
vec2 gloam_hbao_step(vec2 march, float rise, float squared, float radius) {
    float weight = 1.0 - squared / (radius * radius);
    float sine = min(rise * inversesqrt(max(squared, GLOAM_LEAST_SQUARE)), 1.0);
    float added = (sine - march.x) * weight;
    bool rises = weight >= 0.0 && sine > march.x;
    return vec2(rises ? sine : march.x, march.y + (rises ? added : 0.0));
}

// visibility from HBAO's mean over directions (CS-C-visibility): `1 - contrast occ / (1 - sin bias)` [NVIDIA's sample
// of Bavoil and Sainz 2008].
// The divisor compensates the bias.
// occlusion: mean of the y of gloam_hbao_step. bias: radians, that of gloam_hbao_horizon. contrast: 1, or NVIDIA's
// 1.25.
// Returns visibility in [0, 1]; 1 for NaN and for a bias of 1.5 or more. Error: 5e-7 up to 0.8.
float gloam_hbao_visibility(float occlusion, float bias, float contrast) {
    float rest = 1.0 - gloam_sincos_turns(gloam_turns(bias)).y;
    if (!(abs(bias) < 1.5 && occlusion > 0.0 && contrast > 0.0)) return 1.0;
    float visibility = 1.0 - contrast * (occlusion / rest);
    return visibility > 0.0 ? visibility : (visibility <= 0.0 ? 0.0 : 1.0);
}

#endif
