// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_GTAO_GLSL
#define GLOAM_OCCLUSION_GTAO_GLSL

#include "gloam/geometry/slice.glsl"
#include "gloam/sampling/unit_interval.glsl"

// Ground-truth ambient occlusion (Jimenez et al. 2016): two horizons in each slice through the eye, and between them
// the integral in closed form. Each slice's amount is divided, in the end, by what its own half plane would hold: a
// bare plane is then open exactly, at any tilt and with any number of slices. Divided by the number of slices alone
// it reads 0.50 to 1.41 when tilted by 60 degrees.

// higher of the horizon so far and a sample's (GTAO-horizon): `max(c, c_0 + (1 - |v| / R) (v . view / |v| - c_0)) for
// |v| < R` [Jimenez et al. 2016].
// A sample loses weight with its distance, by the linear falloff, which draws its horizon towards the tangent plane.
// horizon: cosine of the angle from the view vector; `lowest` where nothing has been seen. lowest: that of the tangent
// plane on this side, sin n on the negative one, -sin n on the positive. offset: v = s - p in the slice, (along view,
// along tangent), world units. radius: R, world units, > 0.
// Returns a cosine; the horizon itself for an offset as long as the radius or longer, and for NaN. Error: 4e-7.
float gloam_gtao_horizon(float horizon, float lowest, vec2 offset, float radius) {
    float squared = dot(offset, offset);
    float inverse = inversesqrt(max(squared, GLOAM_LEAST_SQUARE));
    float weight = 1.0 - squared * inverse / radius;
    float raised = max(horizon, lowest + (offset.x * inverse - lowest) * weight);
    return weight > 0.0 ? raised : horizon;
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

// what a horizon takes from a slice, from its cosine (GTAO-side): `arc(n + pi / 2 - acos c, (c, sqrt(1 - c^2)), n)`
// [derived from Jimenez et al. 2016, eq 10].
// horizon: cos h of gloam_gtao_horizon, taken to the nearer end outside [-1, 1]. angle: n, radians. normal: (cos n,
// sin n). Both for the positive side; on the negative side -n.
// Returns an amount in [0, pi / 2]; 0 for NaN. Error: 8e-7.
float gloam_gtao_side(float horizon, float angle, vec2 normal) {
    float c = horizon > -1.0 ? min(horizon, 1.0) : -1.0;  // -1 for NaN: nothing taken
    float s = gloam_sqrt((1.0 - c) * (1.0 + c));
    return gloam_gtao_arc(GLOAM_HALF_PI + angle - gloam_unit_angle(vec2(c, s)), vec2(c, s), normal);
}

// Visibility bitmask (Therrien et al. 2023): the half plane of a slice is cut into 32 sectors, and each sample, taken
// to be of constant thickness, covers those between its front and its back. Light passes behind thin things, where a
// horizon would block it. How the half plane is measured decides what is estimated.

// part of a slice below a direction, cosine-weighted (BITMASK-fraction-cosine): `integral of cos(b - n) |sin b| from n
// - pi / 2 to a, over the whole` [derived: the measure of Jimenez et al. 2016].
// Weighted by the cosine to the normal and by solid angle, as in GTAO. The mean over slices, each weighted by the
// length of the projected normal times (cos n + n sin n), is the cosine-weighted occlusion (TSSAO-1).
// direction: (cos a, sin a), (along view, along tangent) in the slice, unit.
// Returns a fraction in [0, 1], of NaN as well. Error: 5e-7.
float gloam_slice_fraction_cosine(vec2 direction, GloamSlice slice) {
    bool negative = direction.y < 0.0;
    vec2 normal = negative ? vec2(slice.normal.x, -slice.normal.y) : slice.normal;
    vec2 horizon = vec2(direction.x, abs(direction.y));
    float elevation = GLOAM_HALF_PI + (negative ? -slice.angle : slice.angle) - gloam_unit_angle(horizon);
    float part = gloam_gtao_arc(elevation, horizon, normal) / gloam_slice_whole(slice);
    return gloam_unit_interval(negative ? part : 1.0 - part);
}

// bits first to last - 1 (BIT-range): `2^last - 2^first` [definition].
// first, last: 0 to 32.
// Returns the bits; none for last <= first. Error: none.
uint gloam_bit_range(uint first, uint last) {
    uint below_last = last >= 32u ? 0xFFFFFFFFu : (1u << last) - 1u;
    uint below_first = first >= 32u ? 0xFFFFFFFFu : (1u << first) - 1u;
    return below_last & ~below_first;
}

// sectors whose centres a sample covers (BITMASK-sectors): `bit i where lower <= (i + 1/2) / 32 < upper` [Therrien et
// al. 2023].
// The mean over ranges is right: thin samples cover a sector as often as they should.
// fractions: (lower, upper), those of the front and of the back in order, in [0, 1], taken to the
// nearer end outside, NaN to 0.
// Returns bits, sector i as bit i; none for upper <= lower. Error: none, but a centre within rounding of an end may
// fall to either side.
uint gloam_bitmask_sectors(vec2 fractions) {
    vec2 ends = ceil(32.0 * vec2(gloam_unit_interval(fractions.x), gloam_unit_interval(fractions.y)) - 0.5);
    return gloam_bit_range(uint(max(ends.x, 0.0)), uint(max(ends.y, 0.0)));
}

// occlusion of a slice by the sectors covered (BITMASK): `bits set / 32` [Therrien et al. 2023].
// sectors: union of the samples' bits.
// Returns occlusion in [0, 1], a multiple of 1/32. Error: none.
float gloam_bitmask_occlusion(uint sectors) {
    return float(gloam_bit_count(sectors)) * 0.03125;
}

#endif
