// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_GTAO_GLSL
#define GLOAM_OCCLUSION_GTAO_GLSL

#include "gloam/geometry/safe_normalize.glsl"
#include "gloam/geometry/slice.glsl"
#include "gloam/numeric/constants.glsl"
#include "gloam/numeric/inverse_trigonometry.glsl"
#include "gloam/numeric/sincos.glsl"
#include "gloam/numeric/unit_angle.glsl"

// Ground-truth ambient occlusion (Jimenez et al. 2016): two horizons in each slice through the eye, and between them
// the integral in closed form. Each slice's amount is divided, in the end, by what its own half plane would hold: a
// bare plane is then open exactly, at any tilt and with any number of slices. Divided by the number of slices alone
// it reads 0.50 to 1.41 when tilted by 60 degrees.

// higher of the horizon so far and a sample's (GTAO-horizon): `max(c, c_0 + w (v . view / |v| - c_0))` [Jimenez et al.
// 2016].
// The higher of the horizon so far and a sample's, which is first drawn towards the tangent plane as it loses weight.
// horizon: cosine of the angle from the view vector, -1 to begin with (nothing seen). lowest: that of the tangent
// plane on this side, sin n on the negative one, -sin n on the positive. offset: s - p, view space, world units. view:
// to the eye, unit. weight: of the sample, [0, 1]: a falloff of |s - p|.
// Returns a cosine in [-1, 1]; the horizon itself for a zero or non-finite offset, and for a weight not positive or
// NaN. Error: 4e-7.
// No method or pass here calls it: it is there to be copied.
float gloam_gtao_horizon(float horizon, float lowest, vec3 offset, vec3 view, float weight) {
    vec3 direction = gloam_safe_normalize(offset, vec3(0.0));
    if (!(weight > 0.0 && dot(direction, direction) > 0.5)) return horizon;
    float cosine = lowest + (dot(direction, view) - lowest) * min(weight, 1.0);
    return cosine > horizon ? min(cosine, 1.0) : horizon;
}

// how far a horizon rises above the tangent plane (GTAO-elevation): `max(n + pi / 2 - acos c, 0)` [Jimenez et al.
// 2016].
// How far a horizon on the positive side rises above the tangent plane within the slice: what lies behind the
// hemisphere is cut off. On the negative side n changes its sign.
// horizon: cosine of gloam_gtao_horizon. angle: n, of the projected normal, radians.
// Returns e, radians in [0, pi]: with h_1 = -acos(c_1) and h_2 = acos(c_2) as in the paper, e_1 = h_1 - (n - pi / 2)
// and e_2 = (n + pi / 2) - h_2. 0 exactly for a horizon of -1, and for a NaN angle; a NaN horizon counts as 0. Error:
// 6e-7.
// No method or pass here calls it: it is there to be copied.
float gloam_gtao_elevation(float horizon, float angle) {
    float e = GLOAM_HALF_PI + angle - gloam_acos(horizon);
    return e > 0.0 ? min(e, GLOAM_PI) : 0.0;
}

// inner integral of a slice as printed, one side (GTAO-inner): `1/4 (-cos(2 h - n) + cos n + 2 h sin n)` [Jimenez et
// al. 2016, eq 10].
// Cosine-weighted visibility between the view vector and a horizon. The sum of both sides is the visibility of the
// slice.
// horizon: h, radians, in [n - pi / 2, 0] on the negative side, in [0, n + pi / 2] on the positive. angle: n, radians.
// Returns an amount in [0, pi / 2]; 0 for NaN. A free half plane has cos n + n sin n in all. Error: 5e-7.
// No method or pass here calls it: it is there to be copied.
float gloam_gtao_inner(float horizon, float angle) {
    vec2 n = gloam_sincos(angle);
    float visible = 0.25 * (n.x - gloam_sincos(2.0 * horizon - angle).x + 2.0 * horizon * n.y);
    return visible > 0.0 ? min(visible, GLOAM_HALF_PI) : 0.0;
}

// what a horizon takes from a slice, cosine-weighted (GTAO-arc): `1/2 (e sin n + cos h cos(h - n))` [derived from
// Jimenez et al. 2016, eq 10].
// Amount by which a horizon on the positive side reduces that: the integral over the angles between the horizon and the
// tangent plane, 1/2 (e sin n + sin(e - n) sin e). e = n + pi / 2 - h is the elevation: sin(e - n) = cos h and sin e =
// cos(h - n), so that no further sine is needed. On the negative side n changes its sign.
// elevation: e, radians in [0, pi], taken to the nearer end outside, NaN to 0. horizon: (cos h, sin h). normal: (cos
// n, sin n).
// Returns an amount in [0, pi / 2]; 0 exactly for e = 0. Error: 3e-7.
float gloam_gtao_arc(float elevation, vec2 horizon, vec2 normal) {
    if (!(elevation > 0.0)) return 0.0;
    float arc = 0.5 * (min(elevation, GLOAM_PI) * normal.y + horizon.x * dot(horizon, normal));
    return arc > 0.0 ? min(arc, GLOAM_HALF_PI) : 0.0;
}

// what a horizon takes from a slice, all directions alike (GTAO-arc-uniform): `1/2 (sin n + cos h)` [derived: the
// integral of |sin| over the arc].
// The same with every direction of the hemisphere weighted alike: 1/2 (sin n + sin(e - n)) = 1/2 (sin n + cos h).
// horizon: cos h. sine: sin n.
// Returns an amount in [0, 1]; 0 for a horizon below the tangent plane and for NaN. A free half plane holds 1. Error:
// 1e-7.
// No method or pass here calls it: it is there to be copied.
float gloam_gtao_arc_uniform(float horizon, float sine) {
    float arc = 0.5 * (sine + horizon);
    return arc > 0.0 ? min(arc, 1.0) : 0.0;
}

// what a horizon takes from a slice, from its cosine (GTAO-side): `arc(n + pi / 2 - acos c, (c, sqrt(1 - c^2)), n)`
// [derived from Jimenez et al. 2016, eq 10].
// Amount by which a horizon reduces a slice's visibility, cosine-weighted, from the horizon's cosine.
// horizon: cos h of gloam_gtao_horizon, taken to the nearer end outside [-1, 1]. angle: n, radians. normal: (cos n,
// sin n). Both for the positive side; on the negative side -n.
// Returns an amount in [0, pi / 2]; 0 for NaN. Error: 8e-7.
float gloam_gtao_side(float horizon, float angle, vec2 normal) {
    float c = horizon > -1.0 ? min(horizon, 1.0) : -1.0;  // -1 for NaN: nothing taken
    float s = gloam_sqrt((1.0 - c) * (1.0 + c));
    return gloam_gtao_arc(GLOAM_HALF_PI + angle - gloam_unit_angle(vec2(c, s)), vec2(c, s), normal);
}

// one more slice in the cosine-weighted occlusion (GTAO-add): `(sum + w (side(c_1, -n) + side(c_2, n)), whole + w (cos
// n + n sin n))` [Jimenez et al. 2016].
// accumulated: (occluded, whole) so far, (0, 0) to begin with. horizons: cosines of gloam_gtao_horizon, negative and
// positive side.
// Returns (occluded, whole) with the slice: its weight times the amount behind the horizons, and its weight times cos
// n + n sin n. Unchanged for a weight that is not positive or not finite. Error: 1.2e-6 a slice.
// No method or pass here calls it: it is there to be copied.
vec2 gloam_gtao_add(vec2 accumulated, GloamSlice slice, vec2 horizons) {
    if (!(slice.weight > 0.0 && slice.weight <= GLOAM_LARGEST)) return accumulated;
    float occluded = gloam_gtao_side(horizons.x, -slice.angle, vec2(slice.normal.x, -slice.normal.y)) +
                     gloam_gtao_side(horizons.y, slice.angle, slice.normal);
    return accumulated + slice.weight * vec2(occluded, gloam_slice_whole(slice));
}

// one more slice in the occlusion of all directions alike (GTAO-add-uniform): `(sum + arc(c_1, -n) + arc(c_2, n), whole
// + 1)` [Jimenez et al. 2016].
// Every slice counts the same.
// accumulated, horizons: as above.
// Returns (occluded, whole) with the slice: the amount behind the horizons, and 1. Unchanged for a weight that is not
// positive.
// Error: 5e-7 a slice.
// No method or pass here calls it: it is there to be copied.
vec2 gloam_gtao_add_uniform(vec2 accumulated, GloamSlice slice, vec2 horizons) {
    if (!(slice.weight > 0.0)) return accumulated;
    float occluded =
        gloam_gtao_arc_uniform(horizons.x, -slice.normal.y) + gloam_gtao_arc_uniform(horizons.y, slice.normal.y);
    return accumulated + vec2(occluded, 1.0);
}

// occlusion of all slices (GTAO): `occluded / whole` [Jimenez et al. 2016, self-normalised].
// accumulated: (occluded, whole).
// Returns occlusion in [0, 1]; 0 exactly where no horizon rises above the tangent plane, 0 where no slice counts and
// for NaN.
// Error: 0.5 ULP.
// No method or pass here calls it: it is there to be copied.
float gloam_gtao_occlusion(vec2 accumulated) {
    if (!(accumulated.x > 0.0 && accumulated.y >= GLOAM_SMALLEST && accumulated.y <= GLOAM_LARGEST_DIVISOR)) return 0.0;
    return accumulated.x < accumulated.y ? min(accumulated.x / accumulated.y, 1.0) : 1.0;
}

#endif
