// SPDX-License-Identifier: MIT
#ifndef GLOAM_TEMPORAL_ROTATION_SWITCH_GLSL
#define GLOAM_TEMPORAL_ROTATION_SWITCH_GLSL

// whether the kernel is rotated at random (TSSAO-ROT): `conv < c_rot` [TSSAO, random rotation].
// Rotation turns banding into noise for the filter; later the plain sequence converges better.
// convergence: conv in [0, 1], of the reprojected and validated history. c_rot: 0.5.
// Returns true as well for NaN in either: an unknown convergence is none. Error: none.
bool gloam_rotation_enabled(float convergence, float c_rot) {
    return !(convergence >= c_rot);
}

#endif
