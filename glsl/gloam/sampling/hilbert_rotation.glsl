// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_HILBERT_ROTATION_GLSL
#define GLOAM_SAMPLING_HILBERT_ROTATION_GLSL

// place on Hilbert's curve (HILBERT-index): `index of (x, y) on the curve through 64 x 64 places, from (0, 0) to
// (63, 0)` [Hilbert 1891].
// Places that follow each other are neighbours, and those of a square block follow each other.
// pixel: modulo 64, so that the curve repeats.
// Returns an index in [0, 4095]. Error: none.
uint gloam_hilbert_index(ivec2 pixel) {
    uvec2 place = uvec2(pixel) & 63u;
    uint index = 0u;
    for (uint side = 32u; side > 0u; side /= 2u) {
        bvec2 beyond = notEqual(place & side, uvec2(0u));
        uint quarter = beyond.x ? (beyond.y ? 2u : 3u) : (beyond.y ? 1u : 0u);
        index += side * side * quarter;
        // Each quarter holds the same curve, mirrored so that it begins where the one before ends.
        if (beyond.y) continue;
        if (beyond.x) place = 63u - place;
        place = place.yx;
    }
    return index;
}

// rotation angle of a pixel by Hilbert's curve (HILBERT-ROT): `2 pi fract(i / p), i the index, p^3 = p + 1` [R2
// sequence (Roberts 2018) along the curve, as XeGTAO has it].
// Neighbouring pixels have angles far from each other, in every square block alike: so less noise is left by a filter
// than with angles at random. fract(14 t) of the angle's turns t is nearly the second coordinate of the R2 sequence:
// gloam_slice_sample takes its jitter from it.
// pixel: integer pixel; the angles repeat after 64 in x and in y.
// Returns an angle in radians, in [0, 2 pi). Error: 3 ulp or 4e-9.
float gloam_hilbert_rotation(ivec2 pixel) {
    uint turn = gloam_hilbert_index(pixel) * 3242174889u;  // 2^32 / p
    return float(turn) * 1.46291807926716e-9;  // 2 pi / 2^32; the largest of the 4096 turns is 0.9998
}

#endif
