// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_EYE_MARCH_GLSL
#define GLOAM_SAMPLING_EYE_MARCH_GLSL

// point of a ray marched in eye space (CS-C2): `p + R (i + jitter) / N w` [Dimitrov, Bavoil and Sainz 2008
// (horizon-split AO)].
// Each point is projected to find its tap. How horizon-split ambient occlusion differs from its successor HBAO, which
// steps in the image. Also the way of Poisson ray marching (Sourimant et al. 2011).
// position: p, view space, world units. direction: w, unit vector; (cos a, sin a, 0) for HSAO. radius: R, world units.
// index: of the step, 0 to count - 1. count: steps, at least 1. jitter: in [0, 1], 1 for none (the last point at the
// radius, the first away from p).
// Returns a point in view space. Error: 1e-6 of R and 1 ULP of p.
vec3 gloam_eye_march(vec3 position, vec3 direction, float radius, uint index, uint count, float jitter) {
    return position + radius * ((float(index) + jitter) / float(count)) * direction;
}

#endif
