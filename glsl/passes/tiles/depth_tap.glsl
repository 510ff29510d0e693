// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_TILES_DEPTH_TAP_GLSL
#define GLOAM_PASSES_TILES_DEPTH_TAP_GLSL

#include "gloam/geometry/background.glsl"

// The data that row.glsl keeps of a pixel, for filters that use depth alone.
struct Tap {
    float occlusion;
    float depth;  // world units
    bool surface;
};

Tap weightless(Tap tap) {
    return Tap(tap.occlusion, tap.depth, false);
}

Tap tap_at(ivec2 pixel) {
    Source source = source_at(pixel);
    return Tap(source.occlusion, source.depth, !gloam_is_background(source.depth));
}

#endif
