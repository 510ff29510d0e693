// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_EYE_MARCH_GLSL
#define GLOAM_SAMPLING_EYE_MARCH_GLSL

#include "gloam/geometry/finite.glsl"
#include "gloam/sampling/unit_interval.glsl"

// point of a ray marched in eye space (CS-C2): `p + R (i + jitter) / N w` [Dimitrov, Bavoil and Sainz 2008
// (horizon-split AO)].
// Each point is projected to find its tap. How horizon-split ambient occlusion (Dimitrov, Bavoil and Sainz 2008)
// differs from its successor HBAO, which steps in the image; what is done with the points is the same. Also the way of
// Poisson ray marching (Sourimant et al. 2011).
// position: p, view space, world units. direction: w, unit vector; (cos a, sin a, 0) for HSAO. radius: R, world
// units, >= 0. index: of the step, 0 to count - 1; outside, the nearer end. count: steps, up to 2^24; below 1 is read
// as 1. jitter: in [0, 1], 1 for none (the last point at the radius, the first away from p); outside, the nearer end;
// 0 for NaN.
// Returns a point in view space; p itself for a radius that is negative or NaN, and where the point would not be
// finite. Error: 1e-6 of R and 1 ULP of p.
// No method or pass here calls it: it is there to be copied.
vec3 gloam_eye_march(vec3 position, vec3 direction, float radius, int index, int count, float jitter) {
    int steps = clamp(count, 1, 16777216);
    float along = (float(clamp(index, 0, steps - 1)) + gloam_unit_interval(jitter)) / float(steps);
    vec3 point = position + radius * along * direction;
    return radius >= 0.0 && gloam_is_finite3(point) ? point : position;
}

#endif
