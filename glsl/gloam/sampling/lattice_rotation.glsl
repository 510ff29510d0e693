// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_LATTICE_ROTATION_GLSL
#define GLOAM_SAMPLING_LATTICE_ROTATION_GLSL

// rotation angle of a pixel on a lattice (LATTICE-ROT): `2 pi fract(x / g^3 + y / g), g the golden ratio` [gloam; the
// sequences of Roberts 2018, over pixels].
// The pixels of every small window have angles far from each other, so a filter leaves less noise than with angles at
// random. The same is true of fract(14 t), t the angle's turns: gloam_slice_sample takes its jitter from it.
// pixel: integer pixel; the products are modulo 2^32. Returns an angle in radians, in [0, 2 pi]. Error: 3 ulp or 4e-9.
float gloam_lattice_rotation(ivec2 pixel) {
    uvec2 turns = uvec2(pixel) * uvec2(1013904243u, 2654435769u);  // 2^32 / g^3, 2^32 / g
    return float(turns.x + turns.y) * 1.46291807926716e-9;  // 2 pi / 2^32
}

#endif
