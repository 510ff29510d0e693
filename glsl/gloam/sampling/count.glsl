// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_COUNT_GLSL
#define GLOAM_SAMPLING_COUNT_GLSL

#include "gloam/numeric/constants.glsl"

// number of samples by the projected size of the kernel (ISSAO-LOD): `clamp(round(most r / r_ref), least, most)`
// [ISSAO, in prose].
// Given in prose only: fewer samples far away. A half is rounded up.
// radius: r, pixels. reference_radius: r_ref, pixels, > 0: from this size on every sample is taken. least, most: 0 <=
// least <= most <= 2^20.
// Returns a count in [least, most]; least for r = 0, negative or NaN, most for r_ref not positive, subnormal or NaN.
// Error: none for r_ref up to 2^126, but for radii within 2 ULP of a half.
int gloam_count_by_radius(float radius, float reference_radius, int least, int most) {
    if (!(reference_radius >= GLOAM_SMALLEST)) return most;
    if (!(radius > 0.0)) return least;
    if (radius >= reference_radius) return most;
    return clamp(int(floor(float(most) * (radius / reference_radius) + 0.5)), least, most);
}

// samples by distance (CS-N): `max(int(base / (1 + base d / z_far)), N_min)` [Aalund and Baerentzen 2013].
// Fewer where less is seen of them.
// depth: d, eye-linear, world units; infinite, negative and NaN count as the far plane. z_far: world units, > 0.
// base: samples next to the eye, up to 4096; below 0 counts as 0. least: samples at any distance, N_min.
// Returns a count >= least; least for a base of 0. A depth of 0 gives base, and so does every one with a far plane
// beyond 2^126, which counts as at infinity; a far plane that is zero, negative, subnormal or NaN lies before every
// depth. Error: none, but a quotient within rounding of a whole number may fall to either side.
int gloam_count_by_distance(float depth, float z_far, int base, int least) {
    float start = float(clamp(base, 0, 4096));
    bool placed = depth >= 0.0 && z_far >= GLOAM_SMALLEST && depth < z_far;
    float distance_part = placed ? (z_far <= GLOAM_LARGEST_DIVISOR ? depth / z_far : 0.0) : 1.0;
    return max(int(start / (1.0 + start * distance_part)), least);
}

// Samples that a method takes where so many are asked for, when it takes them in units. What follows in the sequence
// begins that many samples later.

// samples of whole slices, rays or crosses (SAMPLES-whole): `n max(floor(k / n), 1)` [definition].
// count: k. unit: taps of one; 0 counts as 1. Returns a multiple of the unit. Error: none.
uint gloam_whole_samples(uint count, uint unit) {
    uint taps = max(unit, 1u);
    return max(count / taps, 1u) * taps;
}

// samples of whole pairs (PAIR-samples): `2 ceil(k / 2)` [definition].
// count: k, below 2^32 - 1. Returns the even number that is not below. Error: none.
uint gloam_paired_samples(uint count) {
    return count + (count & 1u);
}

#endif
