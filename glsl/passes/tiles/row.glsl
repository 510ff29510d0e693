// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_TILES_ROW_GLSL
#define GLOAM_PASSES_TILES_ROW_GLSL

// The row that an invocation of the filter reads: its PIXELS pixels, and REACH more on either side. A position in the
// row counts from its start.
// Define before: HOLDS_ROW, PIXELS, REACH and filter_axis(); the type Tap, the data of a pixel; tap_at(pixel), the data
// of a pixel inside the image; and weightless(tap), the same data without weight.
// WebGL does not select structures by ?:, so functions here and in the filters return them by branches.

const int ROW_LENGTH = PIXELS + 2 * REACH;

ivec2 row_start;
Tap row[HOLDS_ROW ? ROW_LENGTH : 1];

Tap read_tap(int position) {
    ivec2 pixel = row_start + position * filter_axis();
    bool inside = pixel.x >= 0 && pixel.y >= 0 && pixel.x < parameters.size.x && pixel.y < parameters.size.y;
    // No branch: clamping costs less than a test at every tap.
    Tap tap = tap_at(clamp(pixel, ivec2(0), parameters.size - 1));
    if (!inside) return weightless(tap);
    return tap;
}

// Reads the row. first: the first pixel of the invocation.
void read_row(ivec2 first) {
    row_start = first - REACH * filter_axis();
    if (!HOLDS_ROW) return;
    UNROLL for (int i = 0; i < ROW_LENGTH; ++i) row[i] = read_tap(i);
}

// The data of the pixel at a position, 0 to ROW_LENGTH - 1; weightless outside the image.
Tap row_tap(int position) {
    if (HOLDS_ROW) return row[position];
    return read_tap(position);
}

#endif
