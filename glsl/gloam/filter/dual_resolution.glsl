// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_DUAL_RESOLUTION_GLSL
#define GLOAM_FILTER_DUAL_RESOLUTION_GLSL

#include "gloam/gather/fetch.glsl"

// where occlusion of half the resolution does not do (CS-E-dual): `max - min > tolerance over 3 x 3` [derived, after
// Bavoil and Sainz 2009].
// pixel: of the small image, inside it. size: of the small image, pixels; neighbours outside are left out. tolerance:
// 0.05 or so.
// Returns whether to compute the pixels beneath in full; true for a NaN tolerance, and where a neighbour is NaN or not
// in [0, 1]. Error: none, but for a range within rounding of the tolerance.
bool gloam_dual_resolution_disagrees(ivec2 pixel, ivec2 size, float tolerance) {
    float low = 1.0;
    float high = 0.0;
    ivec2 first = max(pixel - 1, ivec2(0));
    ivec2 last = min(pixel + 1, size - 1);
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            float occlusion = gloam_fetch_occlusion(ivec2(x, y));
            if (!(occlusion >= 0.0 && occlusion <= 1.0)) return true;
            low = min(low, occlusion);
            high = max(high, occlusion);
        }
    }
    return !(high - low <= tolerance);
}

#endif
