// SPDX-License-Identifier: MIT
#ifndef GLOAM_GATHER_DISTINCT_PIXELS_GLSL
#define GLOAM_GATHER_DISTINCT_PIXELS_GLSL

// Taps that fall into the same pixel read the same depth: of those, one is enough (ISSAO, in prose).

// So many pixels are remembered, the last ones.
const uint GLOAM_DISTINCT_PIXELS = 32u;

// Pixels that a kernel's taps have read.
struct GloamDistinctPixels {
    ivec2 pixels[GLOAM_DISTINCT_PIXELS];  // the number in the order of reading, modulo 32, is the place
    uint count;                           // different ones so far; 0 for none, and then no pixel is read
};

// Adds the pixel of a tap. O(count), at most 32 comparisons.
// known: count set to 0 before the first tap. pixel: of the tap.
// Returns whether it is none of the last 32 different ones; only then it is added. Error: none.
bool gloam_distinct_add(inout GloamDistinctPixels known, ivec2 pixel) {
    uint held = min(known.count, GLOAM_DISTINCT_PIXELS);
    for (uint i = 0u; i < held; ++i) {
        if (known.pixels[i] == pixel) return false;
    }
    known.pixels[known.count % GLOAM_DISTINCT_PIXELS] = pixel;
    known.count += 1u;
    return true;
}

#endif
