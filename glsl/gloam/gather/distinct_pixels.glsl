// SPDX-License-Identifier: MIT
#ifndef GLOAM_GATHER_DISTINCT_PIXELS_GLSL
#define GLOAM_GATHER_DISTINCT_PIXELS_GLSL

// Taps in the same pixel read the same depth, so one of them is enough (ISSAO, in prose). With uniform radii such taps
// are near the shaded pixel. A bit for each of the 8 x 8 pixels around it makes these distinct. (Searching a list of
// the pixels read took ten times as long as the saved taps.)

// The pixels around the shaded one that the taps have read.
struct GloamDistinctPixels {
    ivec2 center;  // the shaded pixel; the others lie 4 to its left and above, 3 to its right and below
    uvec2 seen;    // a bit for each pixel: four rows of 8, and four more; 0 before the first tap
};

// Adds the pixel of a tap.
// Returns false for a pixel of those 8 x 8 that was added before, else true. Error: none.
bool gloam_distinct_add(inout GloamDistinctPixels known, ivec2 pixel) {
    ivec2 at = pixel - known.center + 4;
    if (at.x < 0 || at.y < 0 || at.x > 7 || at.y > 7) return true;
    uint bit = 1u << uint((at.y & 3) * 8 + at.x);
    uvec2 bits = at.y < 4 ? uvec2(bit, 0u) : uvec2(0u, bit);
    bool fresh = (known.seen & bits) == uvec2(0u);
    known.seen |= bits;
    return fresh;
}

#endif
