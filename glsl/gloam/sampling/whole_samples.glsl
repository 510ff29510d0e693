// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_WHOLE_SAMPLES_GLSL
#define GLOAM_SAMPLING_WHOLE_SAMPLES_GLSL

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
