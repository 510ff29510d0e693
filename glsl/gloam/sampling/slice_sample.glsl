// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_SLICE_SAMPLE_GLSL
#define GLOAM_SAMPLING_SLICE_SAMPLE_GLSL

#include "gloam/numeric/sincos.glsl"
#include "gloam/sampling/halton.glsl"

// What is random of a slice.
struct GloamSliceSample {
    vec2 direction;  // unit, in the image; half a turn of directions makes all slices, the other half is their other
                     // side
    float jitter;    // part of a step, [0, 1)
    float share;     // [0, 1), for what else a method needs
};

// what is random of a slice (SLICE-sample): `direction pi fract(x + t), jitter fract(y + 14 t), share z, of the Halton
// point (x, y, z)` [GTAO (Jimenez et al. 2016) with the sequence of TSSAO].
// Slice number `index` of the sequence, 1 for the first.
// turns: t, by which the kernel is rotated (gloam_turns of its angle), [0, 1). Its 14-fold shifts the jitter, so that
// pixels whose directions are alike differ in the jitter. Error: 5e-7.
GloamSliceSample gloam_slice_sample(uint index, float turns) {
    vec3 point = gloam_halton_point(index);
    // 14 t without a rounded product.
    float shift = fract(16.0 * turns) - fract(2.0 * turns);
    return GloamSliceSample(gloam_sincos_turns(0.5 * fract(point.x + turns)), fract(point.y + shift), point.z);
}

// place of a step along half of a slice (SLICE-place): `l + (1 - l) s (0.4 + 0.6 s), l = min(1.3 / r, 1)` [gloam; l as
// XeGTAO has it].
// Steps lie denser near the point, but none so near that it sees only the point's own pixel, which shows nothing.
// share: s, of all steps, [0, 1]. reach: r, of the radius of influence, pixels, > 0.
// Returns a place in [0, 1], in radii. Error: 4 ULP.
float gloam_slice_place(float share, float reach) {
    float least = min(1.3 / reach, 1.0);
    return least + (1.0 - least) * share * (0.4 + 0.6 * share);
}

// coefficients of the places of all steps (SLICE-places): `(a, b, c) where a + b k + c k^2 is the place of the share
// (k + j) / n` [gloam].
// jitter: j, part of a step, [0, 1]. steps: n, at least 1. reach: as in gloam_slice_place. Error: 6e-7.
vec3 gloam_slice_places(float jitter, float steps, float reach) {
    float first = jitter / steps;
    float rest = 1.0 - gloam_slice_place(0.0, reach);
    return vec3(gloam_slice_place(first, reach), rest * (0.4 + 1.2 * first) / steps, rest * 0.6 / (steps * steps));
}

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
