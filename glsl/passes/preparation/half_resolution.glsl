// SPDX-License-Identifier: MIT
#ifndef GLOAM_PREPARATION_HALF_RESOLUTION_GLSL
#define GLOAM_PREPARATION_HALF_RESOLUTION_GLSL

// Which pixels an image of half the resolution stands for: pixel p of it has the result of pixel 2 p of the full one, not that of a point
// between four pixels, so that nothing moves by half a pixel and odd sizes need no care.

// Size of the image of half the resolution. size: of the full image, pixels.
ivec2 gloam_half_size(ivec2 size) {
    return (size + 1) / 2;
}

// The pixel of the full image whose result a pixel of the small one holds.
ivec2 gloam_half_source(ivec2 pixel) {
    return 2 * pixel;
}

#endif
