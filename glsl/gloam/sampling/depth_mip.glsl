// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_DEPTH_MIP_GLSL
#define GLOAM_SAMPLING_DEPTH_MIP_GLSL

// The chain of ever smaller depth images that taps far from their pixel read instead of the full one (SAO): each
// pixel of a level is one pixel of the level before, never a mean. Level l of an image of w x h pixels has max(w >>
// l, 1) x max(h >> l, 1).

// level of the depth chain that a tap reads (CS-Q-level): `clamp(floor(log2(h / first)) + 1, 0, last), h in pixels`
// [McGuire, Mara and Luebke 2012 (Scalable Ambient Obscurance)].
// One more for every doubling of its distance from the pixel.
// pixels: h, distance of the tap from its pixel, in PIXELS of the full image (in texture coordinates it is always
// below `first`, and every tap reads the full image). first: distance from which level 1 is read, pixels, > 0: 16.
// last: the chain's last level, at most
// 30: 5.
// Returns a level in [0, last]: with 16 and 5, 0 below 16 pixels, 1 from 16, 2 from 32, 5 from 256. 0 for a NaN, and
// for `first` not positive or NaN. Error: none.
int gloam_depth_mip_level(float pixels, float first, int last) {
    int level = 0;
    if (!(first > 0.0)) return level;
    float edge = first;
    for (int i = 0; i < min(last, 30) && pixels >= edge; ++i) {
        edge = edge * 2.0;
        level = i + 1;
    }
    return level;
}

// size of a level of the depth chain (CS-Q-size): `max(size >> level, 1)` [Vulkan's rule for the sizes of levels].
// size: of the full image, pixels; below 1 is read as 1. level: 0 to 30; outside, the nearer end.
// Returns max(size >> level, 1). Error: none.
ivec2 gloam_depth_mip_size(ivec2 size, int level) {
    return max(max(size, ivec2(1)) >> clamp(level, 0, 30), ivec2(1));
}

// pixel of a level that stands for one of the full image (CS-Q-pixel): `tap >> level, inside the level` [McGuire, Mara
// and Luebke 2012 (Scalable Ambient Obscurance)].
// tap: pixel of the full image. size: of the full image, pixels. level: 0 to 30; outside, the nearer end.
// Returns tap >> level kept inside the level: the last column and row of an image of odd size stand in the level's
// last. Error: none.
ivec2 gloam_depth_mip_pixel(ivec2 tap, ivec2 size, int level) {
    return clamp(tap >> clamp(level, 0, 30), ivec2(0), gloam_depth_mip_size(size, level) - 1);
}

// pixel of the level before that a pixel takes its depth from (CS-Q-grid): `(2 x + (y & 1), 2 y + (x & 1))` [McGuire,
// Mara and Luebke 2012 (Scalable Ambient Obscurance)].
// A rotated grid, so that no row or column is left out.
// pixel: of the smaller level, inside it. size: of the level before (the larger), pixels; below 1 is read as 1.
// Returns a pixel inside the larger level: the nearest one where a level is one pixel wide or high. Error: none.
ivec2 gloam_rotated_grid(ivec2 pixel, ivec2 size) {
    ivec2 source = 2 * pixel + ivec2(pixel.y & 1, pixel.x & 1);
    return clamp(source, ivec2(0), max(size, ivec2(1)) - 1);
}

// pixel of the full image whose depth a pixel of a level holds (CS-Q-source): `the rotated grid, level by level`
// [derived from the chain of SAO].
// Placing the tap there, and not where it was aimed, keeps a bare plane open at any tilt: the depth is that of this
// pixel.
// pixel: of the level, inside it. size: of the full image, pixels. level: 0 to 30; outside, the nearer end.
// Returns a pixel of the full image. Error: none.
ivec2 gloam_depth_mip_source(ivec2 pixel, ivec2 size, int level) {
    for (int l = clamp(level, 0, 30); l > 0; --l) {
        pixel = gloam_rotated_grid(pixel, gloam_depth_mip_size(size, l - 1));
    }
    return pixel;
}

// The last level of the depth chain that taps read.
const int GLOAM_LAST_TAP_LEVEL = 5;

// pixel whose depth a tap reads (TAP-pixel): `the pixel that the depth chain's texel stands for, of the level for the
// tap's distance` [SAO (McGuire et al. 2012)].
// A texel of the chain holds the depth of one pixel of the full image.
// at, center: pixels of the tap and of the shaded point, inside the image. size: of the image. mip_distance: pixels
// from which level 1 is read, twice as far level 2, and so on; 0, negative or NaN: none is.
// Returns a pixel of the full image. Error: none.
ivec2 gloam_tap_pixel(ivec2 at, ivec2 center, ivec2 size, float mip_distance) {
    ivec2 apart = abs(at - center);
    int level = gloam_depth_mip_level(float(max(apart.x, apart.y)), mip_distance, GLOAM_LAST_TAP_LEVEL);
    return level == 0 ? at : gloam_depth_mip_source(gloam_depth_mip_pixel(at, size, level), size, level);
}

#endif
