// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_HALTON_POINT_GLSL
#define GLOAM_SAMPLING_HALTON_POINT_GLSL

#include "gloam/sampling/halton.glsl"

// The files of this folder hold what is the same for all pixels of a sample, which only its number tells apart. Who
// has it in a table defines the guard and the function before the method is included (passes/samples/table.glsl): a
// look-up then takes the place of the computation.

// Point of the three-dimensional Halton sequence (HALTON), of which slices and rays are made.
// index: number of the point, 1 for the first. Returns a point in [0, 1)^3. Error: at most 2 ulp.
vec3 gloam_halton_point(uint index) {
    return gloam_halton_3d(index);
}

#endif
