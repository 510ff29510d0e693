// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_UNIT_INTERVAL_GLSL
#define GLOAM_SAMPLING_UNIT_INTERVAL_GLSL

// number brought into [0, 1] (UNIT): `x inside [0, 1], else the nearer end; 0 for NaN` [convention].
// How the sample maps read their random coordinates.
// x: any float.
// Returns x inside [0, 1], else the nearer end; 0 for NaN. Error: none.
float gloam_unit_interval(float x) {
    return x > 0.0 ? (x < 1.0 ? x : 1.0) : 0.0;
}

#endif
