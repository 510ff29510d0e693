// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_SWEEP_PAIR_GLSL
#define GLOAM_OCCLUSION_SWEEP_PAIR_GLSL

#include "gloam/geometry/slice.glsl"

// The horizon sweep (gloam/occlusion/sweep.glsl) with both sides of a slice at once, in the axes of the tangent plane
// (gloam/geometry/slice.glsl). The elevation e of a direction over that plane takes the place of its angle from
// the view vector. The amount behind a direction grows with e, so no horizon is kept beside it. Features are found by
// depth and by the places of the steps. Lengths are in radii of influence; x and y are the two sides. The functions
// trust their caller: they test nothing.
struct GloamSweepPair {
    vec2 behind;    // amount between the tangent plane and the horizon
    vec2 counts;    // 1 less half of the last tap's distance, at least 1/2
    vec2 occluded;  // amount so far, each direction with its falloff; without the feature that is not passed yet
    vec2 feature;   // amount of that feature
    vec2 rise;      // of that feature over the surface before it; GLOAM_NO_RISE where there is none
    vec2 start;     // place where it begins
    vec2 nearer;    // by how much the last tap is nearer to the eye than the own point
    float place;    // of the last step, in [0, 1]
};

// The rise where there is no feature: more than 0, so that a quotient by it is finite, and less than any feature's.
const float GLOAM_NO_RISE = 1e-10;
// The least rise of a feature.
const float GLOAM_LEAST_RISE = 1e-4;

// both sides of a slice of which nothing has been seen (FRAME-start): `(0, 1, 0, ..., 0)` [gloam].
// Returns the sides. Error: 1 ulp.
GloamSweepPair gloam_sweep_pair() {
    return GloamSweepPair(vec2(0.0), vec2(1.0), vec2(0.0), vec2(0.0), vec2(GLOAM_NO_RISE), vec2(0.0), vec2(0.0), 0.0);
}

// amounts behind a pair of directions (FRAME-behind): `(sin n (e - sin e cos e) + cos n sin^2 e) / 2` [gloam; the inner
// integral I of Jimenez et al. 2016].
// I(h) = (cos n - cos(2 h - n) + 2 h sin n) / 4, and h = n + pi / 2 - e: then I(n + pi / 2) - I(h) is the formula. The
// first bracket is taken as t sqrt(t) (1.56854 + 0.38684 cos e), t = 1 - cos e: right to 0.009 for e up to 2.2, and by
// which the RMSE of occlusion does not change.
// cosine, sine: of e, for both sides. plane: (cos n, sin n) for the first side; the other has -sin n.
// Returns amounts; each grows with e where e <= pi / 2 + n. Error: 0.005 for e up to 2.2, 0.11 up to pi.
vec2 gloam_pair_behind(vec2 cosine, vec2 sine, vec2 plane) {
    vec2 t = abs(1.0 - cosine);
    vec2 turned = t * sqrt(t) * (0.38684 * cosine + 1.56854);
    return 0.5 * plane.x * sine * sine + vec2(0.5 * plane.y, -0.5 * plane.y) * turned;
}

// both sides with their features that end (FRAME-end): `sum + feature clamp(t w / rise, 0, 1) where x < x_last - 0.8
// rise` [gloam].
// As gloam_sweep_end. nearer: x, by which the taps are nearer than the own point. middle: place between the last step
// and this one. thickness: t, of features, in widths, in [0, 1e18].
// Error: 4e-7, but for falls within rounding of the share.
GloamSweepPair gloam_pair_end(GloamSweepPair pair, vec2 nearer, float middle, float thickness) {
    bvec2 ends = lessThan(nearer, pair.nearer - 0.8 * pair.rise);
    vec2 share = clamp((middle - pair.start) * thickness / pair.rise, 0.0, 1.0);
    pair.occluded = mix(pair.occluded, pair.occluded + pair.feature * share, ends);
    pair.feature = mix(pair.feature, vec2(0.0), ends);
    pair.rise = mix(pair.rise, vec2(GLOAM_NO_RISE), ends);
    return pair;
}

// both sides of a slice with one more tap each (FRAME-tap): `FRAME-end; feature + D (b - behind) where b > behind and D
// > 0 and the tap is higher than the bias, D = clamp(1 - (before + here) / 2, 0, 1)` [gloam].
// As gloam_sweep_tap with a linear falloff.
// taps: what both see, in radii; the own point tells nothing. nearer: by how much they are nearer to the eye, by
// depth. place: of the step, more than that of the last one. plane: (cos n, sin n). bias: least height, >= 0.
// thickness: as in gloam_pair_end.
// Error: 2e-6 but for that of gloam_pair_behind, and for taps within rounding of the bias, or of where a feature ends.
GloamSweepPair gloam_pair_tap(GloamSweepPair pair, vec4 taps, vec2 nearer, float place, vec2 plane, float bias,
                              float thickness) {
    vec2 squared = taps.xy * taps.xy + (taps.zw * taps.zw + GLOAM_LEAST_SQUARE);
    vec2 inverse = inversesqrt(squared);
    vec2 here = squared * inverse;
    vec2 weight = clamp(pair.counts - 0.5 * here, 0.0, 1.0);
    bvec2 contributes = greaterThan(min(weight, taps.zw - bias), vec2(0.0));
    vec2 found = mix(vec2(0.0), gloam_pair_behind(taps.xy * inverse, taps.zw * inverse, plane), contributes);
    vec2 behind = max(found, pair.behind);
    vec2 gain = behind - pair.behind;
    float middle = 0.5 * (place + pair.place);
    GloamSweepPair next = gloam_pair_end(pair, nearer, middle, thickness);
    bvec2 begins = lessThan(next.rise, min(gain, GLOAM_LEAST_RISE));
    next.rise = mix(next.rise, max(nearer - pair.nearer, GLOAM_LEAST_RISE), begins);
    next.start = mix(next.start, vec2(middle), begins);
    next.behind = behind;
    next.feature += weight * gain;
    next.counts = max(1.0 - 0.5 * here, 0.5);
    next.nearer = nearer;
    next.place = place;
    return next;
}

// first moment of what is blocked in a slice (FRAME-bent): `sum of both sides, +-(1 - cos^3 e) t + sin^3 e n, sin^2 e =
// min(2 A, 1)` [gloam; after the bent normal of Jimenez et al. 2016].
// Where the normal is the view vector v, a direction of elevation e has the weight sin e cos e in the slice: A = sin^2
// e / 2 is behind e, and the integral of the directions there is a third of a side. The same e serves tilted normals
// and amounts with a falloff. Twice the normal times FRAME-whole, less this moment, summed over slices by their
// weights, is 3 times the integral of the open directions by the cosine: right to 1 degree, mean, for horizons seen at
// up to 83 degrees.
// occluded: A of both sides, >= 0. plane: (cos n, sin n).
// Returns the moment as factors of t, the tangent plane's axis, and of v: n = (v + sin n t) / cos n, where cos n is at
// least 0.001. Error: 4e-6 for n up to 1.4.
vec2 gloam_bent_slice(vec2 occluded, vec2 plane) {
    vec2 blocked = clamp(2.0 * occluded, 0.0, 1.0);
    vec2 open = clamp(1.0 - 2.0 * occluded, 0.0, 1.0);
    vec2 cubed = open * sqrt(open);
    float towards = dot(blocked, sqrt(blocked)) / max(plane.x, 0.001);
    return vec2(cubed.y - cubed.x + towards * plane.y, towards);
}

#endif
