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
// horizon would block it. How the half plane is measured decides what is estimated: gloam_slice_fraction_* below.

// direction of the back of a sample of some thickness (BITMASK-back): `direction of v - thickness view` [Therrien et
// al. 2023].
// Direction in the slice of a sample's back.
// offset: s - p, view space, world units, the front of the sample. thickness: world units, along the view ray away
// from the eye.
// Returns (along view, along tangent), unit; the direction of the front, which covers nothing, for a thickness not
// positive or not finite, and for a zero or non-finite offset. A sample within rounding of the view ray through p
// covers one side only. Error: 1e-6.
// No method or pass here calls it: it is there to be copied.
vec2 gloam_bitmask_back(vec3 offset, GloamSlice slice, float thickness) {
    vec3 behind = offset - thickness * slice.view;
    vec3 direction = gloam_safe_normalize(offset, vec3(0.0));
    bool thick = thickness > 0.0 && dot(direction, direction) > 0.5 && gloam_is_finite3(behind);
    return gloam_slice_direction(thick ? behind : offset, slice);
}

// part of a slice below a direction, all angles alike (BITMASK-fraction): `(a - n) / pi + 1/2` [Therrien et al. 2023].
// direction: (cos a, sin a) of gloam_slice_direction.
// Returns a fraction in [0, 1]: 0 on the tangent plane on the negative side and below, 1 on the other. Error: 3.5e-7.
// No method or pass here calls it: it is there to be copied.
float gloam_slice_fraction_angle(vec2 direction, GloamSlice slice) {
    return gloam_unit_interval((gloam_atan2(direction.y, direction.x) - slice.angle) * 0.3183098862 + 0.5);
}

// part of a slice below a direction, cosine-weighted (BITMASK-fraction-cosine): `integral of cos(b - n) |sin b| from n
// - pi / 2 to a, over the whole` [derived: the measure of Jimenez et al. 2016].
// The same weighted by the cosine to the normal and by solid angle, as in GTAO. The mean over slices, each weighted by
// the length of the projected normal times (cos n + n sin n), is the cosine-weighted occlusion (TSSAO-1).
// direction: (cos a, sin a) of gloam_slice_direction.
// Returns a fraction in [0, 1], of NaN as well. Error: 5e-7.
float gloam_slice_fraction_cosine(vec2 direction, GloamSlice slice) {
    bool negative = direction.y < 0.0;
    vec2 normal = negative ? vec2(slice.normal.x, -slice.normal.y) : slice.normal;
    vec2 horizon = vec2(direction.x, abs(direction.y));
    float elevation = GLOAM_HALF_PI + (negative ? -slice.angle : slice.angle) - gloam_unit_angle(horizon);
    float part = gloam_gtao_arc(elevation, horizon, normal) / gloam_slice_whole(slice);
    return gloam_unit_interval(negative ? part : 1.0 - part);
}

// part of a slice below a direction, by solid angle (BITMASK-fraction-uniform): `half the integral of |sin b| from n -
// pi / 2 to a` [derived].
// The same weighted by solid angle alone; every slice counts the same.
// direction: (cos a, sin a) of gloam_slice_direction.
// Returns a fraction in [0, 1], of NaN as well. Error: 1.5e-7.
// No method or pass here calls it: it is there to be copied.
float gloam_slice_fraction_uniform(vec2 direction, GloamSlice slice) {
    bool negative = direction.y < 0.0;
    float part = gloam_gtao_arc_uniform(direction.x, negative ? -slice.normal.y : slice.normal.y);
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
// fractions: (lower, upper), those of gloam_slice_fraction_* of front and back in order, in [0, 1], taken to the
// nearer end outside, NaN to 0.
// Returns bits, sector i as bit i; none for upper <= lower. Error: none, but a centre within rounding of an end may
// fall to either side.
uint gloam_bitmask_sectors(vec2 fractions) {
    vec2 ends = ceil(32.0 * vec2(gloam_unit_interval(fractions.x), gloam_unit_interval(fractions.y)) - 0.5);
    return gloam_bit_range(uint(max(ends.x, 0.0)), uint(max(ends.y, 0.0)));
}

// sectors by the rounding of the paper (BITMASK-sectors-outward): `ceil(32 (upper - lower)) bits from floor(32 lower)
// on` [Therrien et al. 2023].
// Every sample that is seen covers a sector at least, so thin ones block too much.
// fractions: (lower, upper), as above.
// Returns bits, sector i as bit i. Error: none, but for ends within rounding of a border of sectors.
// No method or pass here calls it: it is there to be copied.
uint gloam_bitmask_sectors_outward(vec2 fractions) {
    float lower = gloam_unit_interval(fractions.x);
    float width = gloam_unit_interval(fractions.y) - lower;
    uint first = uint(floor(32.0 * lower));
    return width > 0.0 ? gloam_bit_range(first, min(first + uint(ceil(32.0 * width)), 32u)) : 0u;
}

// occlusion of a slice by the sectors covered (BITMASK): `bits set / 32` [Therrien et al. 2023].
// Occlusion of a slice: the part of its sectors that are covered.
// sectors: union of the samples' bits.
// Returns occlusion in [0, 1], a multiple of 1/32. Error: none.
float gloam_bitmask_occlusion(uint sectors) {
    return float(gloam_bit_count(sectors)) * 0.03125;
}

#endif
