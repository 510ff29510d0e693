// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_COUNT_BY_RADIUS_GLSL
#define GLOAM_SAMPLING_COUNT_BY_RADIUS_GLSL

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

#endif
