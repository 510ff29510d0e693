// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_SWEEP_GLSL
#define GLOAM_OCCLUSION_SWEEP_GLSL

#include "gloam/geometry/slice.glsl"
#include "gloam/occlusion/falloff.glsl"

// The horizon sweep: the occlusion of one side of a slice is the integral of D(r(h)) dI(h) over the angles h between
// the tangent plane and the view vector. r(h) is the distance of the first surface along h, and I the inner integral
// of gtao.glsl. A march outwards gives it step by step: a tap above the horizon so far is the first surface along all
// directions between the two, and they count with the falloff of its distance. No horizon is drawn towards the
// tangent plane, and any falloff will do.
//
// A depth buffer does not show how thick things are. A feature is a run of taps that rises above the surface before
// it and ends where the surface falls again. It is taken to be as thick as it is wide, times a setting. If it rises by
// more than that, what lies below its back is open: only that share of its directions counts. A wall does not end
// within the radius, and counts as solid.
struct GloamSweepSide {
    float horizon;   // cosine of the highest tap's angle from the view vector
    float behind;    // amount between the tangent plane and that horizon, [0, pi / 2]
    float before;    // distance of the last tap, in units of the radius, at most 1; of the point itself at first: 0
    float occluded;  // amount so far, each direction with its falloff; without the feature that is not passed yet
    float feature;   // amount of that feature
    float rise;      // of that feature over the surface before it, along the view, in radii; 0 where there is none
    float start;     // its first end along the tangent, in radii
    vec2 last;       // the last tap that saw a surface: (along view, along tangent), in radii
};

// a side of a slice of which nothing has been seen (SWEEP-start): `(cos(n + pi / 2), 0, ..., 0)` [gloam; the inner
// integral of Jimenez et al. 2016].
// lowest: cosine of the tangent plane's angle from the view vector, -sin n.
// Returns the side. Error: none.
GloamSweepSide gloam_sweep_side(float lowest) {
    return GloamSweepSide(lowest, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, vec2(0.0));
}

// where a surface lies that a tap uncovers (SWEEP-distance): `(before + here) / 2` [gloam; the inner integral of
// Jimenez et al. 2016].
// For a surface that rises steadily between both this is exact on average. Whether there is a gap between them is
// unknown with so few taps (docs/methods.md).
// before, here: distances of the two, >= 0.
// Returns a distance. Error: 1 ULP.
float gloam_sweep_distance(float before, float here) {
    return 0.5 * before + 0.5 * here;
}

// what lies between a direction and the tangent plane (SWEEP-behind): `I(n + pi / 2) - I(h)` [gloam; the inner integral
// of Jimenez et al. 2016].
// Amount behind a direction on the positive side: the inner integral between it and the tangent plane, 1/2 (e sin n +
// cos h cos(h - n)), e = n + pi / 2 - h (gloam_gtao_arc). On the negative side n changes its sign (gloam_sweep_slice).
// direction: in the slice, (along view, along tangent), unit, not below the tangent plane; the sign of the latter does
// not matter.
// Returns an amount in [0, pi / 2], 2e-7 less for rounding. Error: 5e-7.
float gloam_sweep_behind(vec2 direction, GloamSlice slice) {
    vec2 upper = vec2(direction.x, abs(direction.y));
    float elevation = GLOAM_HALF_PI + slice.angle - gloam_unit_angle(upper);
    return 0.5 * (elevation * slice.normal.y + upper.x * dot(upper, slice.normal));
}

// a slice as one of its sides sees it (SWEEP-slice): `n times 1 or -1` [definition].
// Mirrored, if needed, so that the side is the positive one.
// towards: 1 for the positive side, -1 for the negative. Returns the slice with n times that. Error: none.
GloamSlice gloam_sweep_slice(GloamSlice slice, float towards) {
    return GloamSlice(slice.view, towards * slice.tangent, vec2(slice.normal.x, towards * slice.normal.y),
                      towards * slice.angle, slice.weight);
}

// a side of a slice with what one more tap uncovers (SWEEP-uncover): `sum + D(rho) (I(H) - I(h)), horizon h, where h <
// H` [gloam; the inner integral of Jimenez et al. 2016].
// As of a solid surface: features are left alone.
// side: so far. slice: of gloam_sweep_slice. offset: of the tap in the slice, (along view, along tangent), in units of
// the radius of influence, longer than 1e-17 where the tap rises, shorter than 1e9. contributes: whether the tap has a
// surface; if not, the side does not change. rises: whether the tap is above the tangent plane; otherwise only its
// distance is kept. falloff: GLOAM_FALLOFF_*.
// Returns the side with the tap. A tap below the horizon or beyond the range of the falloff adds nothing; in the second
// case later taps can still cover its directions. Error: 8e-7.
GloamSweepSide gloam_sweep_uncover(GloamSweepSide side, GloamSlice slice, vec2 offset, bool contributes, bool rises,
                                   uint falloff) {
    float squared = dot(offset, offset);
    float inverse = inversesqrt(max(squared, GLOAM_LEAST_SQUARE));
    float here = squared * inverse;
    vec2 direction = offset * inverse;
    float weight = gloam_falloff_at(falloff, gloam_sweep_distance(side.before, here));
    float behind = gloam_sweep_behind(direction, slice);
    bool uncovers = contributes && rises && direction.x > side.horizon && weight > 0.0;
    float added = uncovers ? weight * (behind - side.behind) : 0.0;
    return GloamSweepSide(uncovers ? direction.x : side.horizon, uncovers ? behind : side.behind,
                          contributes ? min(here, 1.0) : side.before, side.occluded + added, side.feature, side.rise,
                          side.start, side.last);
}

// share of a feature's directions that its thickness covers (SWEEP-share): `min(1, t w / rise)` [gloam].
// width: of the feature along the tangent, >= 0. rise: > 0. thickness: in widths, >= 0.
// Returns a share in [0, 1]. Error: 3 ULP, 1e-30 where the product is subnormal.
float gloam_sweep_share(float width, float rise, float thickness) {
    return min(thickness * width / rise, 1.0);
}

// a side of a slice whose feature ends where the surface falls (SWEEP-end): `sum + feature min(1, t w / rise) where x <
// x_last - 0.8 rise` [gloam].
// at: the tap, (along view, along tangent), the latter >= 0, in radii. thickness: of features, in widths, in [0, 1e18].
// Returns the side; unchanged where no feature ends. Error: 1e-6, but for falls within rounding of the share.
GloamSweepSide gloam_sweep_end(GloamSweepSide side, vec2 at, float thickness) {
    // A return and no choices of members: Filament 1.9's matc crashes on those.
    if (!(side.rise > 0.0 && at.x < side.last.x - 0.8 * side.rise)) return side;
    float width = max(0.5 * (at.y + side.last.y) - side.start, 0.0);
    side.occluded += side.feature * gloam_sweep_share(width, side.rise, thickness);
    side.feature = 0.0;
    side.rise = 0.0;
    return side;
}

// a side of a slice with one more tap (SWEEP-tap): `SWEEP-end, then feature + D(rho) (I(H) - I(h)), horizon h, where h
// < H` [gloam].
// Ends the feature before it where there is one, and begins or continues a feature where the tap uncovers directions.
// Parameters as above.
// Returns the side. Error: 2e-6, but for taps within rounding of where a feature ends.
GloamSweepSide gloam_sweep_tap(GloamSweepSide side, GloamSlice slice, vec2 offset, bool contributes, bool rises,
                               uint falloff, float thickness) {
    vec2 at = contributes ? vec2(offset.x, abs(offset.y)) : side.last;  // nothing changes at the same place
    GloamSweepSide passed = gloam_sweep_end(side, at, thickness);
    float before = passed.occluded;
    passed.occluded = 0.0;
    GloamSweepSide seen = gloam_sweep_uncover(passed, slice, offset, contributes, rises, falloff);
    bool begins = seen.horizon > passed.horizon && !(passed.rise > 0.0);
    seen.feature += seen.occluded;
    seen.occluded = before;
    seen.rise = begins ? max(at.x - side.last.x, 1e-4) : passed.rise;
    seen.start = begins ? 0.5 * (at.y + side.last.y) : passed.start;
    seen.last = at;
    return seen;
}

#endif
