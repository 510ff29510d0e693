// SPDX-License-Identifier: MIT
#ifndef GLOAM_TEMPORAL_NEIGHBORHOOD_GLSL
#define GLOAM_TEMPORAL_NEIGHBORHOOD_GLSL

#include "gloam/geometry/finite.glsl"
#include "gloam/numeric/constants.glsl"
#include "gloam/numeric/square_root.glsl"

// change of the distance to a neighbouring point (TSSAO-9): `||s - p| - |s' - p'||` [TSSAO, eq 9].
// How much the distance between a shaded point and a surface point near it has changed since the last frame
// (TSSAO-9): d = | |s - p| - |s' - p'| |. Common motion of both leaves it 0. With a = s - p and b = s' - p' it is |(a
// - b) . (a + b)| / (|a| + |b|), which subtracts before squaring: the error is that of a and b, not that of their
// lengths.
// sample_position: s, position: p, of this frame; previous_sample: s', previous_position: p', of the previous one.
// World units, one space for each frame; camera-centred positions keep s - p exact.
// Returns the change in world units, >= 0; the largest float, which no threshold exceeds, where a position or
// difference is infinite or NaN. Error: 6 ULP where s - p and s' - p' are exact, else 2e-7 of the larger length
// besides.
// No method or pass here calls it: it is TSSAO, eq 9; the pass takes gloam_probe_change, which has no branch.
float gloam_neighborhood_change(vec3 sample_position, vec3 position, vec3 previous_sample, vec3 previous_position) {
    vec3 a = sample_position - position;
    vec3 b = previous_sample - previous_position;
    if (!(gloam_is_finite3(a) && gloam_is_finite3(b))) return GLOAM_LARGEST;
    vec3 bounds = max(abs(a), abs(b));
    float largest = max(max(bounds.x, bounds.y), bounds.z);
    if (!(largest >= GLOAM_SMALLEST)) return 0.0;
    // Powers of two, so exact: lengths beyond 2^32 or below 2^-32 are squared on another scale.
    float scale = largest > 4294967296.0 ? 8.271806125530277e-25
                                         : (largest < 2.3283064365386963e-10 ? 1.2089258196146292e24 : 1.0);
    a *= scale;
    b *= scale;
    float sum = gloam_sqrt(dot(a, a)) + gloam_sqrt(dot(b, b));
    return min(abs(dot(a - b, a + b)) / sum / scale, GLOAM_LARGEST);
}

// whether a neighbourhood counts as unchanged (TSSAO-9-test): `d < epsilon` [TSSAO, eq 9].
// change: d, world units. epsilon: world units, 0.01 to 0.05 of the kernel radius.
// Returns false for NaN in either. Error: none.
bool gloam_neighborhood_unchanged(float change, float epsilon) {
    return change < epsilon;
}

// whether a surface point can block another at all (TSSAO-9-probe): `(s - p) . n > 0` [TSSAO, eq 9].
// What lies below the tangent plane cannot block, however it moves.
// offset: s - p, world units. normal: n, unit vector, same space.
// Returns false for an offset that is zero, infinite or NaN. A point within rounding of the plane may fall to either
// side.
// No method or pass here calls it: it is TSSAO, eq 9; the pass takes gloam_probe_change, which has no branch.
bool gloam_probe_useful(vec3 offset, vec3 normal) {
    return gloam_is_finite3(offset) && dot(offset, normal) > 0.0;
}

// change of the distance to a sample that may block (TSSAO-9-reach): `||a| - |b|| if min(|a|, |b|) <= r and a . n > 0,
// else 0` [TSSAO, eq 9].
// gloam_neighborhood_change for the surface points under samples, without a branch. What could not block the point in
// either frame does not count. Lengths are subtracted here; that they lose digits does not matter within the reach.
// now: a, from the point to the sample, world units. before: b, the same in the previous frame, in any space: the
// camera's own motion changes no distance. normal: n of the point, unit vector, space of a. reach: r, how far what
// blocks may be, world units, >= 0.
// Returns the change in world units, >= 0; 0 for what does not count, and for NaN in a or n; the largest float where
// the change is infinite or NaN. Lengths are below 1e18. Error: 1.5e-7 of the larger length.
float gloam_probe_change(vec3 now, vec3 before, vec3 normal, float reach) {
    float squared = dot(now, now);
    float squared_before = dot(before, before);
    bool counts = !(squared > reach * reach && squared_before > reach * reach) && dot(now, normal) > 0.0;
    float change = abs(sqrt(squared) - sqrt(squared_before));
    return counts ? (change <= GLOAM_LARGEST ? change : GLOAM_LARGEST) : 0.0;
}

#endif
