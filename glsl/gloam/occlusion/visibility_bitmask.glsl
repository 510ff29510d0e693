// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_VISIBILITY_BITMASK_GLSL
#define GLOAM_OCCLUSION_VISIBILITY_BITMASK_GLSL

#include "gloam/geometry/slice.glsl"
#include "gloam/numeric/bit_count.glsl"
#include "gloam/numeric/constants.glsl"
#include "gloam/numeric/unit_angle.glsl"
#include "gloam/occlusion/gtao.glsl"
#include "gloam/sampling/unit_interval.glsl"

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
