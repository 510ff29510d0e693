// SPDX-License-Identifier: MIT
#ifndef GLOAM_SHADING_BENT_NORMAL_GLSL
#define GLOAM_SHADING_BENT_NORMAL_GLSL

#include "gloam/geometry/length.glsl"
#include "gloam/geometry/safe_normalize.glsl"
#include "gloam/numeric/constants.glsl"
#include "gloam/sampling/unit_interval.glsl"

// Bent normal (Klehm et al. 2011): the mean of the directions in which the point is open, from the samples of any
// estimator that has directions.

// one more direction in a bent normal (CS-L-add): `(sum of V w + V w, sum of V + V)` [Klehm et al. 2011].
// bent: (sum of V w, sum of V) so far, starting at 0. direction: w, unit vector, any space; of uniform density for
// the cones of gloam_cone_angle. visibility: V in [0, 1], 1 open; outside, the nearer end; 0 for NaN.
// Returns the sums with the direction; unchanged for a direction that is not finite. Error: 1 ULP of the sums for
// each addition.
vec4 gloam_bent_add(vec4 bent, vec3 direction, float visibility) {
    return gloam_is_finite3(direction) ? bent + gloam_unit_interval(visibility) * vec4(direction, 1.0) : bent;
}

// bent normal (CS-L): `b = sum of V w / |sum of V w|` [Klehm et al. 2011].
// bent: sums of gloam_bent_add. normal: unit vector, for where nothing is open or the open directions cancel.
// Returns a unit vector, or the normal. Error: 5 ulp in each component.
vec3 gloam_bent_normal(vec4 bent, vec3 normal) {
    return bent.w > 0.0 ? gloam_safe_normalize(bent.xyz, normal) : normal;
}

// how much the open directions agree (CS-L-length): `L = |sum of V w| / sum of V` [Klehm et al. 2011].
// 1/2 for an open hemisphere, 1 for a single direction.
// bent: sums of gloam_bent_add.
// Returns L in [0, 1]; 1 where nothing is open, so that no cone is left, and for a sum of V above 2^126; 0 where the
// sum of V w is not finite. Error: 4e-7 for sums from 1e-18 to 1e18.
float gloam_bent_length(vec4 bent) {
    bool some = bent.w >= GLOAM_SMALLEST && bent.w <= GLOAM_LARGEST_DIVISOR;
    float agreement = some ? gloam_length(bent.xyz) / bent.w : 1.0;
    return agreement < 1.0 ? agreement : 1.0;
}

#endif
