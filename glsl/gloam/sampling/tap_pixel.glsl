// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_TAP_PIXEL_GLSL
#define GLOAM_SAMPLING_TAP_PIXEL_GLSL

#include "gloam/sampling/depth_mip.glsl"

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
