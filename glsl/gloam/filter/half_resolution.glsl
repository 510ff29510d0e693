// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_HALF_RESOLUTION_GLSL
#define GLOAM_FILTER_HALF_RESOLUTION_GLSL

// Which pixels an image of half the resolution stands for: its pixel p has what pixel 2 p of the full image has, not
// that of a point between four pixels. A side of n pixels becomes (n + 1) / 2, so odd sizes need no special case.

// size of an image of half the resolution (HALF-size): `(n + 1) / 2, rounded down` [definition].
// size: of the full image, pixels, 0 to 2^30.
// Error: none.
ivec2 gloam_half_size(ivec2 size) {
    return (size + 1) / 2;
}

// full-size pixel that a half-size pixel stands for (HALF-source): `2 p` [definition].
// pixel: of the half-size image, within 2^30 of 0.
// Error: none.
ivec2 gloam_half_source(ivec2 pixel) {
    return 2 * pixel;
}

#endif
